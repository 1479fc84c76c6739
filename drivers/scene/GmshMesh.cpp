#include "drivers/scene/GmshMesh.hpp"

#include "bem/base/Error.hpp"
#include "drivers/scene/Text.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <system_error>

namespace epafi::drivers {

namespace {

using bem::InputError;
using bem::message;
using Tag = GmshTag;

/// A file line by line, with numbers and quoted names.
class Lines {
 public:
  explicit Lines(const std::string& text) : stream_(text) {}

  /// False at the end of the file.
  bool next() {
    std::string line;
    do {
      if (!std::getline(stream_, line))
        return false;
      ++number_;
      while (!line.empty() && (line.back() == '\r' || line.back() == ' '))
        line.pop_back();
    } while (line.empty());
    words_.clear();
    split(line);
    at_ = 0;
    return true;
  }

  /// The next line, which must be there.
  void need(const char* what) {
    if (!next())
      throw InputError("line ", number_, ": the file ends where ", what,
                       " should follow");
  }

  const std::string& word(const char* what) {
    if (at_ == words_.size())
      fail(message("the line ends where ", what, " should follow"));
    return words_[at_++];
  }

  Tag whole(const char* what) {
    const std::string& text = word(what);
    const auto value = numberIn<Tag>(text);
    if (!value)
      fail(message("'", text, "' is not a whole number; ", what, " is expected"));
    return *value;
  }

  /// A number that counts what follows.
  Tag count(const char* what) {
    const Tag value = whole(what);
    if (value < 0)
      fail(message(what, " is ", value));
    return value;
  }

  double real(const char* what) {
    const std::string& text = word(what);
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
    throw InputError("line ", number_, ": ", what);
  }

 private:
  void split(const std::string& line) {
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

  std::istringstream stream_;
  std::vector<std::string> words_;
  std::size_t at_ = 0;
  int number_ = 0;
};

void checkFormat(Lines& lines) {
  lines.need("the format");
  const std::string version = lines.word("the format's version");
  const Tag type = lines.whole("the file type");
  if (version != "4.1")
    lines.fail(message("format ", version, " is not read, only 4.1; export it again by ",
                       "gmsh OLD.msh -save -format msh41 -o NEW.msh"));
  if (type != 0)
    lines.fail("the mesh is binary; write it as ASCII (Mesh.Binary = 0)");
}

void readNames(Lines& lines, GmshMesh& mesh) {
  lines.need("the number of physical names");
  for (Tag n = lines.count("the number of physical names"); n > 0; --n) {
    lines.need("a physical name");
    const Tag dimension = lines.whole("a dimension");
    const Tag tag = lines.whole("a physical tag");
    const std::string name = lines.word("a physical name");
    if (dimension == 1)
      mesh.names[tag] = name;
  }
}

/// Gmsh marks curves that run backwards by a minus.
Tag physical(Lines& lines) {
  const Tag tag = lines.whole("a physical tag");
  return tag < 0 && tag != std::numeric_limits<Tag>::min() ? -tag : tag;
}

/// Points, then curves; the rest of the section is skipped.
void readEntities(Lines& lines, GmshMesh& mesh) {
  lines.need("the numbers of entities");
  const Tag points = lines.count("the number of points");
  const Tag curves = lines.count("the number of curves");
  for (Tag n = 0; n < points; ++n)
    lines.need("a point");
  for (Tag n = 0; n < curves; ++n) {
    lines.need("a curve");
    const Tag tag = lines.whole("a curve's tag");
    for (int i = 0; i < 6; ++i)
      lines.real("a bounding box");
    for (Tag g = lines.count("the number of physical tags"); g > 0; --g)
      mesh.groups[tag].push_back(physical(lines));
  }
}

void readNodes(Lines& lines, GmshMesh& mesh) {
  lines.need("the numbers of nodes");
  for (Tag blocks = lines.count("the number of blocks"); blocks > 0; --blocks) {
    lines.need("a block of nodes");
    lines.whole("a dimension");
    lines.whole("an entity's tag");
    lines.whole("'parametric'");
    const Tag count = lines.count("the number of nodes");
    std::vector<Tag> tags;
    for (Tag n = 0; n < count; ++n) {
      lines.need("a node's tag");
      tags.push_back(lines.whole("a node's tag"));
    }
    for (const Tag tag : tags) {
      lines.need("a node");
      const double x = lines.real("x");
      const double y = lines.real("y");
      const double z = lines.real("z");
      if (!mesh.nodes.insert({tag, {{x, y}, z}}).second)
        lines.fail(message("node ", tag, " is given twice"));
    }
  }
}

bool isOfHigherOrder(Tag type) {
  return (26 <= type && type <= 28) || (62 <= type && type <= 66);
}

/// The nodes of an element's line, if it is a line.
void addLine(Lines& lines, GmshMesh& mesh, Tag type, Tag group) {
  constexpr Tag segment = 1;
  constexpr Tag secondOrder = 8;
  if (isOfHigherOrder(type))
    lines.fail(
        "a line element of third or higher order; write straight ones or arcs "
        "(Mesh.ElementOrder = 1 or 2)");
  if ((type != segment && type != secondOrder) || group == 0)
    return;
  GmshLine line;
  line.from = lines.whole("a node's tag");
  line.to = lines.whole("a node's tag");
  if (type == secondOrder)
    line.middle = lines.whole("a node's tag");
  line.group = group;
  line.fileLine = lines.number();
  mesh.lines.push_back(line);
}

Tag groupOf(const Lines& lines, const GmshMesh& mesh, Tag curve) {
  const auto found = mesh.groups.find(curve);
  if (found == mesh.groups.end() || found->second.empty())
    return 0;
  if (found->second.size() > 1)
    lines.fail(message("curve ", curve, " belongs to ", found->second.size(),
                       " physical groups; an edge has one name"));
  return found->second.front();
}

void readElements(Lines& lines, GmshMesh& mesh) {
  lines.need("the numbers of elements");
  for (Tag blocks = lines.count("the number of blocks"); blocks > 0; --blocks) {
    lines.need("a block of elements");
    const Tag dimension = lines.whole("a dimension");
    const Tag entity = lines.whole("an entity's tag");
    const Tag type = lines.whole("an element's type");
    const Tag count = lines.count("the number of elements");
    const Tag group = dimension == 1 ? groupOf(lines, mesh, entity) : 0;
    for (Tag n = 0; n < count; ++n) {
      lines.need("an element");
      lines.whole("an element's number");
      addLine(lines, mesh, type, group);
    }
  }
}

}  // namespace

GmshMesh readGmshMesh(const std::string& text) {
  Lines lines(text);
  GmshMesh mesh;
  if (!lines.next() || !lines.is("$MeshFormat"))
    throw InputError("line 1: $MeshFormat is missing; this is no Gmsh mesh");
  checkFormat(lines);
  bool elements = false;
  while (lines.next()) {
    if (lines.is("$PhysicalNames"))
      readNames(lines, mesh);
    else if (lines.is("$Entities"))
      readEntities(lines, mesh);
    else if (lines.is("$Nodes"))
      readNodes(lines, mesh);
    else if (lines.is("$Elements")) {
      readElements(lines, mesh);
      elements = true;
    }
  }
  if (!elements)
    throw InputError("line ", lines.number(), ": the file has no $Elements");
  if (mesh.lines.empty())
    throw InputError(
        "no line element belongs to a physical group; name the boundary's curves "
        "(Physical Curve(\"name\") = {...};)");
  return mesh;
}

}  // namespace epafi::drivers
