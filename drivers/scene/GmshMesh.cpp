#include "drivers/scene/GmshMesh.hpp"

#include "bem/base/Error.hpp"
#include "drivers/scene/Text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>

namespace epafi::drivers {

namespace {

using bem::InputError;
using bem::message;
using Tag = NodeTag;

/// Reads a file section by section: the words of its lines, or in a binary file the bytes
/// of numbers within a section.
class Sections {
 public:
  explicit Sections(const std::string& text) : text_(text) {}

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
      fail(message("the line ends where ", what, " should follow"));
    return words_[word_++];
  }

  /// An int of Gmsh.
  Tag whole(const char* what) {
    if (binary_)
      return bytes<std::int32_t>(what);
    const std::string text = word(what);
    const auto value = numberIn<Tag>(text);
    if (!value)
      fail(message("'", text, "' is not a whole number; ", what, " is expected"));
    return *value;
  }

  /// A size_t of Gmsh: a number of items, or a tag of a node or an element.
  Tag count(const char* what) {
    const Tag value = binary_ ? bytes<std::int64_t>(what) : whole(what);
    if (value < 0)
      fail(message(what, " is ", value));
    return value;
  }

  double real(const char* what) {
    if (binary_) {
      const auto value = bytes<double>(what);
      if (!std::isfinite(value))
        fail(message(what, " is not finite"));
      return value;
    }
    const std::string text = word(what);
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (end != text.c_str() + text.size() || !std::isfinite(value))
      fail(message("'", text, "' is not a finite number; ", what, " is expected"));
    return value;
  }

  bool is(const char* keyword) const {
    return words_.size() == 1 && words_.front() == keyword;
  }
  int number() const { return number_; }

  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(binary_ ? "byte " : "line ", binary_ ? at_ : number_, ": ", what);
  }

  /// Sets the file type of the first section; in a binary file a 1 behind it shows the
  /// byte order.
  void setType(Tag type) {
    if (type != 0 && type != 1)
      fail(message("file type ", type, " is unknown; 0 is ASCII, 1 is binary"));
    fileIsBinary_ = type == 1;
    beginNumbers();
    if (binary_ && whole("1") != 1)
      fail("the mesh was written in another order of bytes; write it as ASCII");
    endNumbers("$EndMeshFormat");
  }

 private:
  [[noreturn]] void failAtEnd(const char* what) const {
    throw InputError("line ", number_, ": the file ends where ", what, " should follow");
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
    for (std::size_t i = 0; i < line.size();) {
      if (line[i] == ' ' || line[i] == '\t') {
        ++i;
        continue;
      }
      const bool quoted = line[i] == '"';
      const std::size_t start = quoted ? i + 1 : i;
      const std::size_t end = line.find_first_of(quoted ? "\"" : " \t", start);
      if (quoted && end == std::string::npos)
        fail("a quoted name has no end");
      words_.push_back(line.substr(start, std::min(end, line.size()) - start));
      i = end == std::string::npos ? line.size() : end + (quoted ? 1 : 0);
    }
  }

  const std::string& text_;
  std::size_t at_ = 0;  ///< index of the next byte
  bool fileIsBinary_ = false;
  bool binary_ = false;
  std::vector<std::string> words_;
  std::size_t word_ = 0;
  int number_ = 0;
};

void readFormat(Sections& file) {
  file.need("the format");
  const std::string version = file.word("the format's version");
  const Tag type = file.whole("the file type");
  if (version != "4.1")
    file.fail(message("format ", version, " is not read, only 4.1; export it again by ",
                      "gmsh OLD.msh -save -format msh41 -o NEW.msh"));
  file.setType(type);
}

void readNames(Sections& file, GmshMesh& mesh) {
  file.need("the number of physical names");
  for (Tag n = file.count("the number of physical names"); n > 0; --n) {
    file.need("a physical name");
    const Tag dimension = file.whole("a dimension");
    const Tag tag = file.whole("a physical tag");
    const std::string name = file.word("a physical name");
    if (dimension == 1)
      mesh.names[tag] = name;
  }
}

/// A physical tag; Gmsh writes it negative for reversed curves.
Tag physical(Sections& file) {
  const Tag tag = file.whole("a physical tag");
  return tag < 0 && tag != std::numeric_limits<Tag>::min() ? -tag : tag;
}

/// Reads the rest of a point or curve behind its tag: bounding box, then physical groups.
std::vector<Tag> groupsOfEntity(Sections& file, int reals) {
  for (int i = 0; i < reals; ++i)
    file.real("a bounding box");
  std::vector<Tag> groups;
  for (Tag g = file.count("the number of physical tags"); g > 0; --g)
    groups.push_back(physical(file));
  return groups;
}

/// Reads points and curves; the rest of the section is skipped.
void readEntities(Sections& file, GmshMesh& mesh) {
  file.need("the numbers of entities");
  const Tag points = file.count("the number of points");
  const Tag curves = file.count("the number of curves");
  for (const char* what : {"the number of surfaces", "the number of volumes"})
    file.count(what);
  for (Tag n = 0; n < points; ++n) {
    file.need("a point");
    file.whole("a point's tag");
    groupsOfEntity(file, 3);
  }
  for (Tag n = 0; n < curves; ++n) {
    file.need("a curve");
    const Tag tag = file.whole("a curve's tag");
    mesh.groups[tag] = groupsOfEntity(file, 6);
    for (Tag ends = file.count("the number of end points"); ends > 0; --ends)
      file.whole("a point's tag");
  }
}

/// Returns the number of blocks and skips the other numbers of the line.
Tag countBlocks(Sections& file, const char* what) {
  file.need(what);
  const Tag blocks = file.count("the number of blocks");
  for (int i = 0; i < 3; ++i)
    file.count(what);
  return blocks;
}

void readNodes(Sections& file, GmshMesh& mesh) {
  for (Tag blocks = countBlocks(file, "the numbers of nodes"); blocks > 0; --blocks) {
    file.need("a block of nodes");
    const Tag dimension = file.whole("a dimension");
    file.whole("an entity's tag");
    const bool parametric = file.whole("'parametric'") != 0;
    const Tag count = file.count("the number of nodes");
    std::vector<Tag> tags;
    for (Tag n = 0; n < count; ++n) {
      file.need("a node's tag");
      tags.push_back(file.count("a node's tag"));
    }
    for (const Tag tag : tags) {
      file.need("a node");
      const double x = file.real("x");
      const double y = file.real("y");
      const double z = file.real("z");
      for (Tag i = 0; parametric && i < std::min<Tag>(dimension, 3); ++i)
        file.real("a parameter");
      if (!mesh.nodes.insert({tag, {{x, y}, z}}).second)
        file.fail(message("node ", tag, " is given twice"));
    }
  }
}

bool isOfHigherOrder(Tag type) {
  return (26 <= type && type <= 28) || (62 <= type && type <= 66);
}

Tag groupOf(const Sections& file, const GmshMesh& mesh, Tag curve) {
  const auto found = mesh.groups.find(curve);
  if (found == mesh.groups.end() || found->second.empty())
    return 0;
  if (found->second.size() > 1)
    file.fail(message("curve ", curve, " belongs to ", found->second.size(),
                      " physical groups; an edge has one name"));
  return found->second.front();
}

/// Reads a block of line elements on a curve.
void readLines(Sections& file, GmshMesh& mesh, Tag type, Tag group, Tag count) {
  constexpr Tag segment = 1;
  constexpr Tag secondOrder = 8;
  for (Tag n = 0; n < count; ++n) {
    file.need("an element");
    file.count("an element's number");
    if (isOfHigherOrder(type))
      file.fail(
          "a line element of third or higher order; write straight ones or arcs "
          "(Mesh.ElementOrder = 1 or 2)");
    if (type != segment && type != secondOrder)
      file.fail(message("an element of type ", type, " on a curve"));
    GmshLine line;
    line.from = file.count("a node's tag");
    line.to = file.count("a node's tag");
    if (type == secondOrder)
      line.middle = file.count("a node's tag");
    line.group = group;
    line.fileLine = file.number();
    if (group != 0)
      mesh.lines.push_back(line);
  }
}

/// Reads points and lines; the elements in the plane behind them are skipped.
void readElements(Sections& file, GmshMesh& mesh) {
  for (Tag blocks = countBlocks(file, "the numbers of elements"); blocks > 0; --blocks) {
    file.need("a block of elements");
    const Tag dimension = file.whole("a dimension");
    const Tag entity = file.whole("an entity's tag");
    const Tag type = file.whole("an element's type");
    const Tag count = file.count("the number of elements");
    if (dimension == 1) {
      readLines(file, mesh, type, groupOf(file, mesh, entity), count);
      continue;
    }
    if (dimension > 1 && file.isBinary())
      return;  // Gmsh writes them behind all lines
    for (Tag n = 0; n < count; ++n) {
      file.need("an element");
      file.count("an element's number");
      file.count("a node's tag");
    }
  }
}

}  // namespace

GmshMesh readGmshMesh(const std::string& text) {
  struct Section {
    const char* name;
    void (*read)(Sections& file, GmshMesh& mesh);
  };
  constexpr Section numbers[] = {
      {"Entities", readEntities}, {"Nodes", readNodes}, {"Elements", readElements}};
  Sections file(text);
  GmshMesh mesh;
  if (!file.next() || !file.is("$MeshFormat"))
    throw InputError("line 1: $MeshFormat is missing; this is no Gmsh mesh");
  readFormat(file);
  bool elements = false;
  while (file.next()) {
    if (file.is("$PhysicalNames"))
      readNames(file, mesh);
    for (const Section& section : numbers)
      if (file.is(message("$", section.name).c_str())) {
        file.beginNumbers();
        section.read(file, mesh);
        file.endNumbers(message("$End", section.name));
        elements = elements || section.read == readElements;
        break;
      }
  }
  if (!elements)
    throw InputError("line ", file.number(), ": the file has no $Elements");
  if (mesh.lines.empty())
    throw InputError(
        "no line element belongs to a physical group; name the boundary's curves "
        "(Physical Curve(\"name\") = {...};)");
  return mesh;
}

}  // namespace epafi::drivers
