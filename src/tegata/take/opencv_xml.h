// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tegata {

/// An element of the XML that OpenCV's FileStorage writes; attributes are passed over.
struct XmlElement {
  std::string name;
  std::string text;  ///< outside of its children, entities resolved
  std::vector<XmlElement> children;
};

/// The root element. Throws Error (without the file's name) where tags do not close in order.
XmlElement parse_opencv_xml(std::string_view content);

}  // namespace tegata
