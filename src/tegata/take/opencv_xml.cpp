// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/opencv_xml.h"

#include <algorithm>
#include <array>
#include <utility>

#include "tegata/base/error.h"

namespace tegata {
namespace {

constexpr std::string_view kXmlBlanks = " \t\r\n";
constexpr int kDeepest = 32;

class XmlParser {
 public:
  explicit XmlParser(std::string_view content) : content_(content) {}

  XmlElement root() {
    skip_remarks();
    if (next_tag_name().empty()) throw Error("got no XML element, expected <opencv_storage>");
    return element(0);
  }

 private:
  // The end of what starts here, or Error.
  std::size_t find(std::string_view end, std::string_view what) const {
    const std::size_t found = content_.find(end, at_);
    if (found == std::string_view::npos) throw Error("got ", what, " without its end '", end, "'");
    return found;
  }

  bool starts(std::string_view with) const { return content_.substr(at_).starts_with(with); }

  // Blanks, <?...?>, <!-- ... --> and <!...>.
  void skip_remarks() {
    for (;;) {
      at_ = std::min(content_.find_first_not_of(kXmlBlanks, at_), content_.size());
      if (starts("<?")) {
        at_ = find("?>", "a declaration") + 2;
      } else if (starts("<!--")) {
        at_ = find("-->", "a comment") + 3;
      } else if (starts("<!")) {
        at_ = find(">", "a declaration") + 1;
      } else {
        return;
      }
    }
  }

  std::string next_tag_name() const {
    if (!starts("<")) return {};
    const std::size_t end = content_.find_first_of(" \t\r\n/>", at_ + 1);
    return std::string(content_.substr(at_ + 1, end - at_ - 1));
  }

  XmlElement element(int depth) {
    if (depth > kDeepest) throw Error("got elements nested ", depth, " deep, expected fewer");
    XmlElement parsed;
    parsed.name = next_tag_name();
    const std::size_t end = find(">", "a tag");
    const bool closed = content_[end - 1] == '/';
    at_ = end + 1;
    while (!closed) {
      const std::size_t tag = find("<", "an element");
      parsed.text += resolved(content_.substr(at_, tag - at_));
      at_ = tag;
      if (starts("</")) {
        ++at_;  // so that the name begins after the slash
        const std::size_t close = find(">", "a tag");
        if (content_.substr(at_ + 1, close - at_ - 1) != parsed.name) {
          throw Error("got the end of '", content_.substr(at_ + 1, close - at_ - 1),
                      "', expected that of '", parsed.name, "'");
        }
        at_ = close + 1;
        break;
      }
      skip_remarks();
      if (starts("<") && !starts("</")) parsed.children.push_back(element(depth + 1));
    }
    return parsed;
  }

  static std::string resolved(std::string_view text) {
    constexpr std::array<std::pair<std::string_view, char>, 5> kEntities = {
        {{"&lt;", '<'}, {"&gt;", '>'}, {"&amp;", '&'}, {"&apos;", '\''}, {"&quot;", '"'}}};
    std::string plain;
    while (!text.empty()) {
      std::size_t length = 1;
      char value = text.front();
      for (const auto& [entity, character] : kEntities) {
        if (!text.starts_with(entity)) continue;
        length = entity.size();
        value = character;
      }
      plain += value;
      text.remove_prefix(length);
    }
    return plain;
  }

  std::string_view content_;
  std::size_t at_ = 0;
};

}  // namespace

XmlElement parse_opencv_xml(std::string_view content) { return XmlParser(content).root(); }

}  // namespace tegata
