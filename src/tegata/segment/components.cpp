// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Pieces are sets of runs, the stretches of one label in a row, which are few: a row is scanned
// once, and runs that touch those of the row above are joined.
#include "tegata/segment/components.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace tegata {
namespace {

struct Run {
  int y, first, last;  // columns; `last` is not in it
  std::size_t parent;  // another run of the same piece, or itself
  std::size_t pixels;  // of the whole piece, in the run that is its own parent
  bool at_edge;        // the same: whether the piece touches the edge of the picture
};

// The first pixel from `first` on with another label than it, or `last`.
const PixelLabel* end_of_run(const PixelLabel* first, const PixelLabel* last) {
  const PixelLabel label = *first;
  std::uint64_t same = 0, some = 0;  // eight pixels at a time
  std::memset(&same, static_cast<int>(label), sizeof(same));
  for (; last - first >= std::ptrdiff_t{sizeof(same)}; first += sizeof(same)) {
    std::memcpy(&some, first, sizeof(some));
    if (some != same) break;
  }
  return std::find_if(first, last, [&](PixelLabel other) { return other != label; });
}

class Pieces {
 public:
  // `reach` is 1 where pieces join over corners as well, or 0.
  Pieces(const Silhouette& silhouette, PixelLabel label, int reach) {
    std::size_t above = 0;  // the first run of the row above
    for (int y = 0; y < silhouette.height(); ++y) {
      const std::size_t begin = runs_.size();
      find_runs(silhouette, label, y);
      join(above, begin, reach);
      above = begin;
    }
    for (std::size_t i = 0; i < runs_.size(); ++i) runs_[i].parent = root(i);
  }

  const std::vector<Run>& runs() const { return runs_; }
  const Run& piece_of(const Run& run) const { return runs_[run.parent]; }
  bool is_piece(std::size_t run) const { return runs_[run].parent == run; }

 private:
  void find_runs(const Silhouette& silhouette, PixelLabel label, int y) {
    const int width = silhouette.width();
    const PixelLabel* const row =
        silhouette.values().data() + static_cast<std::ptrdiff_t>(y) * width;
    for (int x = 0; x < width;) {
      const auto* const found = static_cast<const PixelLabel*>(
          std::memchr(row + x, static_cast<int>(label), static_cast<std::size_t>(width - x)));
      if (found == nullptr) break;
      const int first = static_cast<int>(found - row);
      x = static_cast<int>(end_of_run(found, row + width) - row);
      const bool at_edge = y == 0 || y + 1 == silhouette.height() || first == 0 || x == width;
      runs_.push_back({y, first, x, runs_.size(), static_cast<std::size_t>(x - first), at_edge});
    }
  }

  // Joins the runs from `begin` on with those of the row above, which are the ones before them.
  void join(std::size_t above, std::size_t begin, int reach) {
    std::size_t run = begin;
    while (above < begin && run < runs_.size()) {
      const Run &a = runs_[above], &b = runs_[run];
      if (a.first < b.last + reach && b.first < a.last + reach) unite(above, run);
      if (a.last < b.last) {
        ++above;
      } else {
        ++run;
      }
    }
  }

  std::size_t root(std::size_t run) {
    while (runs_[run].parent != run) {
      runs_[run].parent = runs_[runs_[run].parent].parent;
      run = runs_[run].parent;
    }
    return run;
  }

  void unite(std::size_t a, std::size_t b) {
    a = root(a);
    b = root(b);
    if (a == b) return;
    const auto [first, second] = std::minmax(a, b);
    runs_[second].parent = first;
    runs_[first].pixels += runs_[second].pixels;
    runs_[first].at_edge = runs_[first].at_edge || runs_[second].at_edge;
  }

  std::vector<Run> runs_;
};

void paint(Silhouette& silhouette, const Run& run, PixelLabel label) {
  std::fill(&silhouette(run.first, run.y), &silhouette(run.last - 1, run.y) + 1, label);
}

}  // namespace

void keep_large_components(Silhouette& silhouette, double smallest_share) {
  const Pieces pieces(silhouette, PixelLabel::hand, 1);
  const Run* largest = nullptr;
  for (std::size_t i = 0; i < pieces.runs().size(); ++i) {
    const Run& piece = pieces.runs()[i];
    if (pieces.is_piece(i) && (largest == nullptr || piece.pixels > largest->pixels)) {
      largest = &piece;
    }
  }
  if (largest == nullptr) return;
  const double smallest = smallest_share * static_cast<double>(largest->pixels);
  for (const Run& run : pieces.runs()) {
    const Run& piece = pieces.piece_of(run);
    if (&piece == largest) continue;
    if (smallest_share >= 1.0 || static_cast<double>(piece.pixels) < smallest) {
      paint(silhouette, run, PixelLabel::background);
    }
  }
}

void drop_large_components(Silhouette& silhouette, std::size_t most_px) {
  const Pieces pieces(silhouette, PixelLabel::hand, 1);
  for (const Run& run : pieces.runs()) {
    if (pieces.piece_of(run).pixels > most_px) paint(silhouette, run, PixelLabel::background);
  }
}

void keep_components_with(Silhouette& silhouette, const Silhouette& seeds) {
  const Pieces pieces(silhouette, PixelLabel::hand, 1);
  std::vector<bool> has_seed(pieces.runs().size(), false);
  for (const Run& run : pieces.runs()) {
    const PixelLabel* const first = &seeds(run.first, run.y);
    const PixelLabel* const last = first + (run.last - run.first);
    if (std::find(first, last, PixelLabel::hand) != last) has_seed[run.parent] = true;
  }
  for (const Run& run : pieces.runs()) {
    if (!has_seed[run.parent]) paint(silhouette, run, PixelLabel::background);
  }
}

void fill_pinholes(Silhouette& silhouette, int largest_px) {
  const Pieces pieces(silhouette, PixelLabel::background, 0);
  for (const Run& run : pieces.runs()) {
    const Run& piece = pieces.piece_of(run);
    if (piece.pixels <= static_cast<std::size_t>(largest_px) && !piece.at_edge) {
      paint(silhouette, run, PixelLabel::hand);
    }
  }
}

}  // namespace tegata
