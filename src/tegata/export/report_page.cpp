// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/report_page.h"

#include <fmt/format.h>

#include <map>
#include <numbers>

#include "tegata/export/report_charts.h"
#include "tegata/export/report_html.h"
#include "tegata/take/staged_folder.h"

namespace tegata {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

constexpr std::string_view kStyle = R"css(
:root { color-scheme: light dark; --paper: #fbfbf9; --ink: #1c1d1f; --soft: #6a6d72;
  --rule: #dcdcd6; --card: #ffffff; --heat: 30, 120, 190; --bad: #b3361b;
  --c0: #0072b2; --c1: #c35200; --c2: #007f5c; --c3: #a4508b; }
@media (prefers-color-scheme: dark) { :root { --paper: #17181b; --ink: #ececea; --soft: #a0a3a8;
  --rule: #34363b; --card: #1f2125; --heat: 80, 170, 235; --bad: #ff8a70;
  --c0: #56b4e9; --c1: #f0953f; --c2: #3fc79a; --c3: #dd92c4; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink);
  font: 16px/1.5 system-ui, sans-serif; }
main { max-width: 68rem; margin: 0 auto; padding: 1.5rem 1rem 4rem; }
h1 { font-size: 1.7rem; line-height: 1.2; margin: 0 0 .3rem; overflow-wrap: anywhere; }
h2 { font-size: 1.2rem; margin: 2.4rem 0 .6rem; }
h3 { font-size: 1rem; margin: 0 0 .3rem; }
p { margin: .3rem 0 .8rem; }
.soft, figcaption, .legend { color: var(--soft); font-size: .88rem; }
dl { display: grid; grid-template-columns: repeat(auto-fit, minmax(9.5rem, 1fr)); gap: .7rem;
  margin: 1.2rem 0; }
dl div, .card { background: var(--card); border: 1px solid var(--rule); border-radius: .5rem;
  padding: .7rem .9rem; }
dt { color: var(--soft); font-size: .85rem; }
dd { margin: 0; font-size: 1.25rem; font-variant-numeric: tabular-nums; overflow-wrap: anywhere; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: .88rem; font-variant-numeric: tabular-nums; }
th, td { padding: .3rem .6rem; text-align: right; border-bottom: 1px solid var(--rule);
  white-space: nowrap; }
th { font-weight: 600; }
th[scope=row], th:first-child, .text { text-align: left; }
tr.doubt td { color: var(--bad); }
table.heat { border-collapse: separate; border-spacing: 2px; }
table.heat td { border: 0; border-radius: 3px; text-align: center; padding: .2rem .3rem;
  background: rgba(var(--heat), calc(.06 + .64 * var(--support, 0))); }
table.heat th { border: 0; padding: .2rem .4rem; }
table.heat td.none { background: none; }
table.narrow { border-spacing: 0; }
table.narrow td { min-width: 5px; height: 1.3rem; padding: 0; border-radius: 0; }
table.narrow th + th { padding: 0; }
.charts { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 26rem), 1fr));
  gap: .8rem; }
svg { display: block; width: 100%; height: auto; }
svg text { fill: var(--soft); font-size: 12px; }
.grid { stroke: var(--rule); }
path { fill: none; stroke-width: 2; stroke-linejoin: round; }
.mean { stroke-dasharray: 5 4; opacity: .7; }
.line0 { stroke: var(--c0); } .line1 { stroke: var(--c1); }
.line2 { stroke: var(--c2); } .line3 { stroke: var(--c3); }
.point0 { fill: var(--c0); } .point1 { fill: var(--c1); }
.point2 { fill: var(--c2); } .point3 { fill: var(--c3); }
.legend span { white-space: nowrap; margin-right: .9rem; }
.legend span::before { content: ""; display: inline-block; width: .8rem; height: .8rem;
  border-radius: 50%; margin-right: .35rem; vertical-align: -.1rem; background: var(--dot); }
.key0 { --dot: var(--c0); } .key1 { --dot: var(--c1); }
.key2 { --dot: var(--c2); } .key3 { --dot: var(--c3); }
.seen { --dot: #46c8ff; } .fitted { --dot: #ff8c00; }
.pictures { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 18rem), 1fr));
  gap: .8rem; }
figure { margin: 0; }
img { display: block; width: 100%; height: auto; border-radius: .4rem; background: #000; }
)css";

std::vector<std::string> cameras_of(const Result& result) {
  std::map<std::string, bool> seen;
  std::vector<std::string> cameras;
  for (const ResultFrame& frame : result.frames) {
    for (const std::string& view : frame.views) {
      if (!seen[view]) cameras.push_back(view);
      seen[view] = true;
    }
  }
  return cameras;
}

std::string summary(const Result& result) {
  std::size_t ok = 0, overlap_count = 0;
  double overlap = 0.0, seconds = 0.0;
  for (const ResultFrame& frame : result.frames) {
    if (frame.status != "ok") continue;
    ++ok;
    for (const auto& [camera, iou] : frame.silhouette_iou) {
      overlap += iou;
      ++overlap_count;
    }
  }
  for (const auto& [stage, spent] : result.seconds) seconds += spent;
  const auto tile = [](std::string_view name, const std::string& value) {
    return fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", name, value);
  };
  std::string html = "<dl>\n";
  html += tile("frames that are ok", fmt::format("{} of {}", ok, result.frames.size()));
  html += tile("mean silhouette overlap",
               overlap_count == 0
                   ? "none"
                   : fmt::format("{:.2f}", overlap / static_cast<double>(overlap_count)));
  html += tile("iterations", fmt::format("{}", result.iterations));
  html += tile("the fit ended with", escape_html(result.termination));
  html += tile("seconds of work", fmt::format("{:.1f}", seconds));
  return html + "</dl>\n";
}

std::string grasp_table(const Result& result) {
  std::string html =
      "<table>\n<tr><th scope=\"col\">digit</th><th scope=\"col\">abduction</th>"
      "<th scope=\"col\">first joint</th><th scope=\"col\">second</th>"
      "<th scope=\"col\">third</th></tr>\n";
  for (int digit = 0; digit < kDigitCount; ++digit) {
    const std::string_view name = angle_names()[static_cast<std::size_t>(4 * digit)];
    html += fmt::format("<tr><th scope=\"row\">{}</th>", name.substr(0, name.find('_')));
    for (int angle = 4 * digit; angle < 4 * digit + 4; ++angle) {
      html += fmt::format("<td>{:.1f}° ± {:.1f}°</td>", result.grasp_angles[angle] * kDegrees,
                          result.grasp_standard_deviations[angle] * kDegrees);
    }
    html += "</tr>\n";
  }
  return html + "</table>\n";
}

std::string picture_grid(const std::vector<ReportPicture>& pictures) {
  std::string html = "<div class=\"pictures\">\n";
  for (const ReportPicture& picture : pictures) {
    const std::string caption =
        fmt::format("frame {}, camera {}", escape_html(picture.frame), escape_html(picture.camera));
    html += fmt::format(
        "<figure><img src=\"data:image/jpeg;base64,{}\" alt=\"{}, with outlines\"/>"
        "<figcaption>{}</figcaption></figure>\n",
        encode_base64(picture.jpeg), caption, caption);
  }
  return html + "</div>\n";
}

std::string frame_table(const Result& result) {
  const std::vector<std::string> cameras = cameras_of(result);
  std::string html = "<table>\n<tr><th scope=\"col\">frame</th><th scope=\"col\">time</th>";
  for (const std::string& camera : cameras) {
    html += fmt::format("<th scope=\"col\">{}</th>", escape_html(camera));
  }
  html += "<th class=\"text\" scope=\"col\">status</th></tr>\n";
  for (const ResultFrame& frame : result.frames) {
    html += fmt::format("<tr{}><th scope=\"row\">{}</th><td>{:.3f} s</td>",
                        frame.status == "ok" ? "" : " class=\"doubt\"", escape_html(frame.name),
                        frame.time);
    for (const std::string& camera : cameras) {
      const auto overlap = frame.silhouette_iou.find(camera);
      html += overlap == frame.silhouette_iou.end()
                  ? "<td></td>"
                  : fmt::format("<td>{:.2f}</td>", overlap->second);
    }
    html += fmt::format("<td class=\"text\">{}</td></tr>\n", escape_html(frame.status));
  }
  return html + "</table>\n";
}

}  // namespace

void write_report_page(const Result& result, const std::vector<ReportPicture>& pictures,
                       const std::filesystem::path& file) {
  const std::string take = escape_html(result.take);
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
      "<title>{}: grasp of a {} hand</title>\n<style>{}</style>\n</head>\n<body>\n<main>\n",
      take, side_name(result.side), kStyle);
  html += fmt::format("<h1>{}</h1>\n<p class=\"soft\">A {} hand, fitted with the model {}.</p>\n",
                      take, side_name(result.side), escape_html(result.model_name));
  html += summary(result);
  if (!pictures.empty()) {
    html +=
        "<h2>Pictures</h2>\n<p class=\"legend\"><span class=\"seen\">what the picture shows of the "
        "hand</span> <span class=\"fitted\">the fitted hand</span></p>\n";
    html += picture_grid(pictures);
  }
  html +=
      "<h2>Grasp</h2>\n<p class=\"soft\">Joint angles with their standard deviations. Zero is the "
      "flat hand with straight fingers; flexion is positive towards the palm.</p>\n";
  html += "<div class=\"wide\">" + grasp_table(result) + "</div>\n";
  html +=
      "<h2>Joint angles over the frames</h2>\n<p class=\"soft\">Dashed: the grasp's own.</p>\n"
      "<div class=\"charts\">\n";
  for (int digit = 0; digit < kDigitCount; ++digit) {
    const std::string_view name = angle_names()[static_cast<std::size_t>(4 * digit)];
    html += fmt::format("<section class=\"card\"><h3>{}</h3>\n{}</section>\n",
                        name.substr(0, name.find('_')), angle_chart(result, digit));
  }
  html +=
      "</div>\n<h2>Support</h2>\n<p class=\"soft\">How much of each bone the pictures back up: 1 "
      "seen and explained, 0 hidden or contradicted.</p>\n";
  html += "<div class=\"wide\">" + support_table(result) + "</div>\n";
  html +=
      "<h2>Frames</h2>\n<p class=\"soft\">Overlap of the fitted hand with the silhouette of each "
      "camera: intersection over union.</p>\n";
  html += "<div class=\"wide\">" + frame_table(result) + "</div>\n</main>\n</body>\n</html>\n";
  write_file(file, html);
}

}  // namespace tegata
