// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/report_charts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tegata/export/report_html.h"

namespace tegata {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr int kAnglesPerDigit = 4;
constexpr double kWidth = 480.0, kHeight = 210.0;
constexpr double kLeft = 44.0, kRight = 12.0, kTop = 10.0, kBottom = 26.0;
constexpr double kGridDeg = 30.0;
constexpr std::size_t kMostMarkedFrames = 60;    // beyond, points would run together
constexpr std::size_t kMostNumberedFrames = 24;  // beyond, the support's numbers would not fit

/// From frame positions and degrees to the drawing.
struct Axes {
  std::size_t frame_count = 0;
  double low_deg = 0.0, high_deg = 0.0;

  double x(std::size_t frame) const {
    const double share =
        frame_count < 2 ? 0.5 : static_cast<double>(frame) / static_cast<double>(frame_count - 1);
    return kLeft + share * (kWidth - kLeft - kRight);
  }
  double y(double degrees) const {
    return kTop + (high_deg - degrees) / (high_deg - low_deg) * (kHeight - kTop - kBottom);
  }
};

Axes fit_axes(const Result& result, int digit) {
  double low = 0.0, high = 60.0;
  const auto include = [&low, &high, digit](const JointAngles& angles) {
    for (int i = 0; i < kAnglesPerDigit; ++i) {
      low = std::min(low, angles[kAnglesPerDigit * digit + i] * kDegrees);
      high = std::max(high, angles[kAnglesPerDigit * digit + i] * kDegrees);
    }
  };
  include(result.grasp_angles);
  for (const ResultFrame& frame : result.frames) {
    if (frame.pose) include(frame.pose->angles);
  }
  return {result.frames.size(), kGridDeg * std::floor(low / kGridDeg),
          kGridDeg * std::ceil(high / kGridDeg)};
}

std::string draw_grid(const Axes& axes, const Result& result) {
  std::string svg;
  for (double degrees = axes.low_deg; degrees <= axes.high_deg + 1.0; degrees += kGridDeg) {
    svg += fmt::format(
        "<line class=\"grid\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>"
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{:.0f}°</text>\n",
        kLeft, axes.y(degrees), kWidth - kRight, axes.y(degrees), kLeft - 6.0,
        axes.y(degrees) + 4.0, degrees);
  }
  const auto label = [&](std::size_t frame, std::string_view anchor) {
    svg +=
        fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", axes.x(frame),
                    kHeight - 8.0, anchor, escape_html(result.frames[frame].name));
  };
  if (result.frames.size() == 1) label(0, "middle");
  if (result.frames.size() > 1) {
    label(0, "start");
    label(result.frames.size() - 1, "end");
  }
  return svg;
}

std::string draw_angle(const Axes& axes, const Result& result, int angle) {
  const int line = angle % kAnglesPerDigit;
  std::string path, points;
  bool pen_is_down = false;
  for (std::size_t i = 0; i < result.frames.size(); ++i) {
    const auto& pose = result.frames[i].pose;
    if (pose) {
      const double x = axes.x(i), y = axes.y(pose->angles[angle] * kDegrees);
      path += fmt::format("{}{:.1f} {:.1f}", pen_is_down ? " L" : " M", x, y);
      if (result.frames.size() <= kMostMarkedFrames) {
        points += fmt::format("<circle class=\"point{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\"/>",
                              line, x, y);
      }
    }
    pen_is_down = pose.has_value();
  }
  const double mean = axes.y(result.grasp_angles[angle] * kDegrees);
  std::string svg = fmt::format(
      "<line class=\"line{} mean\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>\n",
      line, kLeft, mean, kWidth - kRight, mean);
  if (!path.empty())
    svg += fmt::format("<path class=\"line{}\" d=\"{}\"/>\n", line, path.substr(1));
  return svg + points + "\n";
}

}  // namespace

std::string angle_chart(const Result& result, int digit) {
  const Axes axes = fit_axes(result, digit);
  const std::string_view name = angle_names()[static_cast<std::size_t>(kAnglesPerDigit * digit)];
  const std::string_view digit_name = name.substr(0, name.find('_'));
  std::string svg = fmt::format(
      "<svg viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" aria-label=\"Joint angles of the {} over "
      "the frames\">\n",
      kWidth, kHeight, digit_name);
  svg += draw_grid(axes, result);
  std::string legend = "<p class=\"legend\">";
  for (int i = 0; i < kAnglesPerDigit; ++i) {
    const int angle = kAnglesPerDigit * digit + i;
    svg += draw_angle(axes, result, angle);
    const std::string_view full = angle_names()[static_cast<std::size_t>(angle)];
    legend += fmt::format("<span class=\"key{}\">{}</span> ", i,
                          spoken_name(full.substr(full.find('_') + 1)));
  }
  return svg + "</svg>\n" + legend + "</p>\n";
}

std::string support_table(const Result& result) {
  const bool numbered = result.frames.size() <= kMostNumberedFrames;
  std::string html = fmt::format("<table class=\"heat{}\">\n<tr><th scope=\"col\">bone</th>",
                                 numbered ? "" : " narrow");
  for (const ResultFrame& frame : result.frames) {
    html +=
        numbered ? fmt::format("<th scope=\"col\">{}</th>", escape_html(frame.name)) : "<th></th>";
  }
  html += "</tr>\n";
  for (std::size_t bone = 0; bone < kBoneCount; ++bone) {
    const std::string name = spoken_name(bone_names()[bone]);
    html += fmt::format("<tr><th scope=\"row\">{}</th>", name);
    for (const ResultFrame& frame : result.frames) {
      if (!frame.pose) {
        html += "<td class=\"none\"></td>";
        continue;
      }
      const double support = frame.support[bone];
      html += fmt::format("<td title=\"{}, {}: {:.2f}\" style=\"--support:{:.2f}\">{}</td>", name,
                          escape_html(frame.name), support, support,
                          numbered ? fmt::format("{:.2f}", support) : "");
    }
    html += "</tr>\n";
  }
  return html + "</table>\n";
}

}  // namespace tegata
