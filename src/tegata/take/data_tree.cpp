// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/take/data_tree.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "tegata/base/error.h"
#include "tegata/take/opencv_xml.h"
#include "tegata/take/staged_folder.h"

namespace tegata {
namespace {

constexpr std::size_t kLargestFile = 4u << 20;
constexpr std::string_view kBlanks = " \t\r\n";

const YAML::Node& as_node(const std::shared_ptr<const void>& node) {
  return *static_cast<const YAML::Node*>(node.get());
}

std::string_view kind_of(const YAML::Node& node) {
  switch (node.Type()) {
    case YAML::NodeType::Map:
      return "a map";
    case YAML::NodeType::Sequence:
      return "a sequence";
    case YAML::NodeType::Scalar:
      return "a value";
    default:
      return "nothing";
  }
}

// Words between blanks; what stands in double quotes is one.
std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  for (std::size_t at = text.find_first_not_of(kBlanks); at != std::string_view::npos;
       at = text.find_first_not_of(kBlanks, at)) {
    const bool quoted = text[at] == '"';
    if (quoted) ++at;
    const std::size_t end =
        std::min(quoted ? text.find('"', at) : text.find_first_of(kBlanks, at), text.size());
    words.emplace_back(text.substr(at, end - at));
    at = std::min(quoted ? end + 1 : end, text.size());
  }
  return words;
}

// OpenCV names the items of a sequence "_" and lists simple ones as words.
YAML::Node node_of(const XmlElement& element) {
  if (element.children.empty()) {
    const std::vector<std::string> words = words_of(element.text);
    if (words.size() == 1) return YAML::Node(words.front());
    YAML::Node list(YAML::NodeType::Sequence);
    for (const std::string& word : words) list.push_back(word);
    return list;
  }
  const bool sequence = element.children.front().name == "_";
  YAML::Node node(sequence ? YAML::NodeType::Sequence : YAML::NodeType::Map);
  for (const XmlElement& child : element.children) {
    if (sequence) {
      node.push_back(node_of(child));
    } else {
      node[child.name] = node_of(child);
    }
  }
  return node;
}

double finite_number(const DataTree& where, std::string_view written) {
  if (written.starts_with('+')) written.remove_prefix(1);
  double number = 0.0;
  const char* const end = written.data() + written.size();
  const auto [last, problem] = std::from_chars(written.data(), end, number);
  if (problem != std::errc() || last != end || !std::isfinite(number)) {
    where.fail(text("'", written.substr(0, 40), "'"), "a finite number");
  }
  return number;
}

}  // namespace

DataTree::DataTree(std::shared_ptr<const void> node, std::string file, std::string path)
    : node_(std::move(node)), file_(std::move(file)), path_(std::move(path)) {
  where_ = path_.empty() ? file_ : text(file_, ": '", path_, "'");
}

DataTree DataTree::read(const std::filesystem::path& file) {
  return parse(read_file(file), file.string());
}

DataTree DataTree::parse(const std::string& content, const std::string& file) {
  if (content.size() > kLargestFile) {
    throw Error(file, ": got ", content.size(), " bytes, expected a calibration of at most ",
                kLargestFile);
  }
  const std::size_t first = content.find_first_not_of(kBlanks);
  const bool xml = first != std::string::npos && content[first] == '<';
  try {
    return {std::make_shared<const YAML::Node>(xml ? node_of(parse_opencv_xml(content))
                                                   : YAML::Load(content)),
            file, ""};
  } catch (const YAML::Exception& error) {
    throw Error(file, ": not YAML or JSON: ", error.what());
  } catch (const Error& error) {
    throw Error(file, ": not OpenCV's XML: ", error.what());
  }
}

bool DataTree::is_map() const { return as_node(node_).IsMap(); }
bool DataTree::is_sequence() const { return as_node(node_).IsSequence(); }

std::vector<std::string> DataTree::keys() const {
  std::vector<std::string> keys;
  if (!is_map()) return keys;
  for (const auto& entry : as_node(node_)) {
    if (entry.first.IsScalar()) keys.push_back(entry.first.Scalar());
  }
  return keys;
}

bool DataTree::has(std::string_view key) const {
  return is_map() && as_node(node_)[std::string(key)].IsDefined();
}

DataTree DataTree::child(std::string_view key) const { return child_of({key}); }

DataTree DataTree::child_of(const std::vector<std::string_view>& keys) const {
  for (const std::string_view key : keys) {
    if (!has(key)) continue;
    return {std::make_shared<const YAML::Node>(as_node(node_)[std::string(key)]), file_,
            path_.empty() ? std::string(key) : text(path_, ".", key)};
  }
  throw Error(where_, ": key '", keys.front(), "' is missing");
}

std::vector<DataTree> DataTree::items() const {
  const YAML::Node& node = as_node(node_);
  if (!node.IsSequence()) fail(kind_of(node), "a sequence");
  std::vector<DataTree> items;
  for (std::size_t i = 0; i < node.size(); ++i) {
    items.push_back(
        DataTree(std::make_shared<const YAML::Node>(node[i]), file_, text(path_, "[", i, "]")));
  }
  return items;
}

std::string DataTree::string() const {
  const YAML::Node& node = as_node(node_);
  if (!node.IsScalar()) fail(kind_of(node), "a value");
  return node.Scalar();
}

double DataTree::number() const { return finite_number(*this, string()); }

void DataTree::append_numbers(std::vector<double>& numbers, int depth) const {
  constexpr int kDeepest = 3;
  constexpr std::size_t kMost = 1000;
  const YAML::Node& node = as_node(node_);
  if (node.IsScalar()) {
    numbers.push_back(number());
  } else if (depth == 0 && node.IsMap() && has("data")) {
    child("data").append_numbers(numbers, 1);
    if (has("rows") && has("cols") &&
        child("rows").number() * child("cols").number() != static_cast<double>(numbers.size())) {
      fail(text(numbers.size(), " numbers"), "as many as rows and cols say");
    }
  } else if (node.IsSequence() && depth < kDeepest) {
    for (const DataTree& item : items()) item.append_numbers(numbers, depth + 1);
  } else {
    fail(kind_of(node), "numbers");
  }
  if (numbers.size() > kMost) fail(text("more than ", kMost, " numbers"), "those of a camera");
}

std::vector<double> DataTree::numbers() const {
  std::vector<double> numbers;
  append_numbers(numbers, 0);
  return numbers;
}

std::vector<double> DataTree::numbers(std::size_t count) const {
  std::vector<double> values = numbers();
  if (values.size() != count) fail(text(values.size(), " numbers"), text(count, " numbers"));
  return values;
}

Eigen::Vector3d DataTree::vector3() const {
  return Eigen::Map<const Eigen::Vector3d>(numbers(3).data());
}

Eigen::Matrix3d DataTree::matrix3() const {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(numbers(9).data());
}

void DataTree::fail(std::string_view got, std::string_view expected) const {
  throw Error(where_, ": got ", got, ", expected ", expected);
}

}  // namespace tegata
