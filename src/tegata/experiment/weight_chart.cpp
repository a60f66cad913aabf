// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/experiment/weight_chart.h"

#include <fmt/format.h>

#include <string_view>

namespace tegata {
namespace {

constexpr double kPanelWidth = 120.0, kPanelHeight = 110.0, kGap = 16.0;
constexpr double kLeft = 34.0, kTop = 26.0, kBottom = 44.0;
constexpr std::array<std::string_view, kDigitCount> kDigitNames = {"thumb", "index", "middle",
                                                                   "ring", "little"};

double mean_of_digit(const std::array<double, kBoneCount>& values, int digit) {
  const auto first = static_cast<std::size_t>(1 + 3 * digit);
  return (values[first] + values[first + 1] + values[first + 2]) / 3.0;
}

std::string text_at(double x, double y, std::string_view anchor, std::string_view words) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor,
                     words);
}

std::string line(const std::string& points, std::string_view style) {
  return fmt::format("<polyline points=\"{}\" fill=\"none\" {}/>\n", points, style);
}

std::string panel(const WeightRecord& record, int digit, double left) {
  std::string weights, support;
  const double last =
      record.frames.size() > 1 ? static_cast<double>(record.frames.size() - 1) : 1.0;
  for (std::size_t k = 0; k < record.frames.size(); ++k) {
    const double x = left + kPanelWidth * static_cast<double>(k) / last;
    const auto point = [&](double value) {
      return fmt::format("{:.1f},{:.1f} ", x, kTop + (1.0 - value) * kPanelHeight);
    };
    weights += point(mean_of_digit(record.frames[k].weights, digit));
    support += point(mean_of_digit(record.frames[k].support, digit));
  }
  return fmt::format(
             "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"none\" "
             "stroke=\"#bbb\"/>\n",
             left, kTop, kPanelWidth, kPanelHeight) +
         text_at(left + 0.5 * kPanelWidth, kTop - 8.0, "middle",
                 kDigitNames[static_cast<std::size_t>(digit)]) +
         line(support, "stroke=\"#888\" stroke-width=\"1.5\" stroke-dasharray=\"4 3\"") +
         line(weights, "stroke=\"#c0392b\" stroke-width=\"2\"") +
         text_at(left, kTop + kPanelHeight + 14.0, "start", "1") +
         text_at(left + kPanelWidth, kTop + kPanelHeight + 14.0, "end",
                 fmt::format("{}", record.frames.size()));
}

}  // namespace

std::string weights_csv(const WeightRecord& record) {
  std::string csv = "frame,bone,weight,support\n";
  for (const WeightRecord::Frame& frame : record.frames) {
    for (std::size_t bone = 0; bone < frame.weights.size(); ++bone) {
      csv += fmt::format("{},{},{:.4f},{:.4f}\n", frame.name, bone_names()[bone],
                         frame.weights[bone], frame.support[bone]);
    }
  }
  return csv;
}

std::string weights_svg(const WeightRecord& record) {
  const double width = kLeft + kDigitCount * (kPanelWidth + kGap);
  const double height = kTop + kPanelHeight + kBottom;
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
      "height=\"{1:.0f}\" font-family=\"sans-serif\" font-size=\"11\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
      width, height);
  svg += text_at(kLeft - 6.0, kTop + 9.0, "end", "1");
  svg += text_at(kLeft - 6.0, kTop + kPanelHeight, "end", "0");
  for (int digit = 0; digit < kDigitCount; ++digit) {
    svg += panel(record, digit, kLeft + digit * (kPanelWidth + kGap));
  }
  svg += text_at(kLeft, height - 10.0, "start",
                 "over the frames: mean robust weight of each digit (red), share of it that the "
                 "cameras see (grey, dashed)");
  return svg + "</svg>\n";
}

}  // namespace tegata
