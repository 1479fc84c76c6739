#pragma once

#include "bem/base/Error.hpp"
#include "drivers/scene/OutlineChain.hpp"
#include "drivers/scene/Text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

namespace epafi::drivers {

/// Reads a .msh file section by section: the words of its lines, or in a binary file the bytes
/// of numbers within a section.
class GmshSections {
 public:
  explicit GmshSections(const std::string& text) : text_(text) {}

  /// Goes to the next non-empty line; false at the end of the file.
  bool next() {
    std::string line;
    do {
      if (at_ >= text_.size())
        return false;
      const std::size_t end = std::min(text_.find('\n', at_), text_.size());
      line = text_.substr(at_, end - at_);
      at_ = std::min(end + 1, text_.size());
      ++number_;
      while (!line.empty() && (line.back() == '\r' || line.back() == ' '))
        line.pop_back();
    } while (line.empty());
    split(line);
    return true;
  }

  /// Goes to the next line, which must exist; does nothing within binary numbers.
  void need(const char* what) {
    if (!binary_ && !next())
      failAtEnd(what);
  }

  bool isBinary() const { return fileIsBinary_; }
  /// In a binary file the rest of the section consists of bytes.
  void beginNumbers() { binary_ = fileIsBinary_; }
  /// Continues behind the line `end` and skips what is before it.
  void endNumbers(const std::string& end) {
    if (!binary_)
      return;
    binary_ = false;
    at_ = text_.find(end, at_);
    if (at_ == std::string::npos)
      failAtEnd(end.c_str());
  }

  std::string word(const char* what) {
    if (word_ == words_.size())
      fail(bem::message("the line ends where ", what, " should follow"));
    return words_[word_++];
  }

  /// An int of Gmsh.
  NodeTag whole(const char* what) {
    if (binary_)
      return bytes<std::int32_t>(what);
    const std::string text = word(what);
    const auto value = numberIn<NodeTag>(text);
    if (!value)
      fail(bem::message("'", text, "' is not a whole number; ", what, " is expected"));
    return *value;
  }

  /// A size_t of Gmsh: a number of items, or a tag of a node or an element.
  NodeTag count(const char* what) {
    const NodeTag value = binary_ ? bytes<std::int64_t>(what) : whole(what);
    if (value < 0)
      fail(bem::message(what, " is ", value));
    return value;
  }

  double real(const char* what) {
    if (binary_) {
      const auto value = bytes<double>(what);
      if (!std::isfinite(value))
        fail(bem::message(what, " is not finite"));
      return value;
    }
    const std::string text = word(what);
    const auto value = finiteIn(text);
    if (!value)
      fail(bem::message("'", text, "' is not a finite number; ", what, " is expected"));
    return *value;
  }

  bool is(const char* keyword) const {
    return words_.size() == 1 && words_.front() == keyword;
  }
  int number() const { return number_; }

  [[noreturn]] void fail(const std::string& what) const {
    throw bem::InputError(binary_ ? "byte " : "line ", binary_ ? at_ : number_, ": ",
                          what);
  }

  /// Sets the file type of the first section; in a binary file a 1 behind it shows the
  /// byte order.
  void setType(NodeTag type) {
    if (type != 0 && type != 1)
      fail(bem::message("file type ", type, " is unknown; 0 is ASCII, 1 is binary"));
    fileIsBinary_ = type == 1;
    beginNumbers();
    if (binary_ && whole("1") != 1)
      fail("the mesh was written in another order of bytes; write it as ASCII");
    endNumbers("$EndMeshFormat");
  }

 private:
  [[noreturn]] void failAtEnd(const char* what) const {
    throw bem::InputError("line ", number_, ": the file ends where ", what,
                          " should follow");
  }

  template <class Number>
  Number bytes(const char* what) {
    Number value;
    if (text_.size() - at_ < sizeof value)
      failAtEnd(what);
    std::memcpy(&value, text_.data() + at_, sizeof value);
    at_ += sizeof value;
    return value;
  }

  void split(const std::string& line) {
    words_.clear();
    word_ = 0;
    std::istringstream words(line);
    for (std::string word; words >> std::ws && !words.eof(); words_.push_back(word))
      if (!(words >> std::quoted(word, '"', '\0')))
        fail("a quoted name has no end");
  }

  const std::string& text_;
  std::size_t at_ = 0;  ///< index of the next byte
  bool fileIsBinary_ = false;
  bool binary_ = false;
  std::vector<std::string> words_;
  std::size_t word_ = 0;
  int number_ = 0;
};

}  // namespace epafi::drivers
