#include "drivers/scene/GmshOutline.hpp"

#include "bem/base/Error.hpp"
#include "bem/geometry/Crossing.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <set>
#include <sstream>

namespace epafi::drivers {

namespace {

using bem::InputError;
using bem::Loop;
using bem::message;
using bem::Vec2;
using Tag = long;

/// Two lines whose directions differ by less (in radians) are one edge.
constexpr double straight = 1e-9;

/// Two arcs that meet at a smaller angle (in radians) and whose curvatures differ by a
/// smaller share are parts of one circle: coordinates of 7 digits say no more.
constexpr double oneCircle = 1e-6;

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
      throw InputError(
          message("line ", number_, ": the file ends where ", what, " should follow"));
  }

  const std::string& word(const char* what) {
    if (at_ == words_.size())
      fail(message("the line ends where ", what, " should follow"));
    return words_[at_++];
  }

  Tag whole(const char* what) {
    const std::string& text = word(what);
    Tag value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end)
      fail(message("'", text, "' is not a whole number; ", what, " is expected"));
    return value;
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
    throw InputError(message("line ", number_, ": ", what));
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

struct Node {
  Vec2 place;
  double z = 0;
};

struct Line {
  Tag from = 0;
  Tag to = 0;
  Tag middle = 0;  ///< of a line of second order, else 0
  Tag group = 0;
  int fileLine = 0;
};

/// What is needed of a .msh file.
struct MeshFile {
  std::map<Tag, std::string> names;        // of the physical curves
  std::map<Tag, std::vector<Tag>> groups;  // of the curves, format 4.1
  std::map<Tag, Node> nodes;
  std::vector<Line> lines;
};

enum class Format { V2, V4 };

Format readFormat(Lines& lines) {
  lines.need("the format");
  const std::string version = lines.word("the format's version");
  const Tag type = lines.whole("the file type");
  if (type != 0)
    lines.fail("the mesh is binary; write it as ASCII (Mesh.Binary = 0)");
  if (version == "2.2" || version == "2.1" || version == "2")
    return Format::V2;
  if (version == "4.1")
    return Format::V4;
  lines.fail(message("format ", version, " is not read; write 2.2 or 4.1 ",
                     "(Mesh.MshFileVersion = 4.1)"));
}

void readNames(Lines& lines, MeshFile& mesh) {
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
void readEntities(Lines& lines, MeshFile& mesh) {
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

void addNode(Lines& lines, MeshFile& mesh, Tag tag) {
  const double x = lines.real("x");
  const double y = lines.real("y");
  const double z = lines.real("z");
  if (!mesh.nodes.insert({tag, {{x, y}, z}}).second)
    lines.fail(message("node ", tag, " is given twice"));
}

void readNodes2(Lines& lines, MeshFile& mesh) {
  lines.need("the number of nodes");
  for (Tag n = lines.count("the number of nodes"); n > 0; --n) {
    lines.need("a node");
    const Tag tag = lines.whole("a node's tag");
    addNode(lines, mesh, tag);
  }
}

void readNodes4(Lines& lines, MeshFile& mesh) {
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
      addNode(lines, mesh, tag);
    }
  }
}

constexpr Tag secondOrder = 8;

bool isOfHigherOrder(Tag type) {
  return (26 <= type && type <= 28) || (62 <= type && type <= 66);
}

/// The nodes of an element's line, if it is a line.
void addLine(Lines& lines, MeshFile& mesh, Tag type, Tag group) {
  constexpr Tag segment = 1;
  if (isOfHigherOrder(type))
    lines.fail(
        "a line element of third or higher order; write straight ones or arcs "
        "(Mesh.ElementOrder = 1 or 2)");
  if ((type != segment && type != secondOrder) || group == 0)
    return;
  Line line;
  line.from = lines.whole("a node's tag");
  line.to = lines.whole("a node's tag");
  if (type == secondOrder)
    line.middle = lines.whole("a node's tag");
  line.group = group;
  line.fileLine = lines.number();
  mesh.lines.push_back(line);
}

void readElements2(Lines& lines, MeshFile& mesh) {
  lines.need("the number of elements");
  for (Tag n = lines.count("the number of elements"); n > 0; --n) {
    lines.need("an element");
    lines.whole("an element's number");
    const Tag type = lines.whole("an element's type");
    const Tag tags = lines.count("the number of tags");
    const Tag group = tags > 0 ? physical(lines) : 0;
    for (Tag t = 1; t < tags; ++t)
      lines.whole("a tag");
    addLine(lines, mesh, type, group);
  }
}

Tag groupOf(const Lines& lines, const MeshFile& mesh, Tag curve) {
  const auto found = mesh.groups.find(curve);
  if (found == mesh.groups.end() || found->second.empty())
    return 0;
  if (found->second.size() > 1)
    lines.fail(message("curve ", curve, " belongs to ", found->second.size(),
                       " physical groups; an edge has one name"));
  return found->second.front();
}

void readElements4(Lines& lines, MeshFile& mesh) {
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

MeshFile readFile(const std::string& text) {
  Lines lines(text);
  MeshFile mesh;
  if (!lines.next() || !lines.is("$MeshFormat"))
    throw InputError("line 1: $MeshFormat is missing; this is no Gmsh mesh");
  const Format format = readFormat(lines);
  const bool four = format == Format::V4;
  bool elements = false;
  while (lines.next()) {
    if (lines.is("$PhysicalNames"))
      readNames(lines, mesh);
    else if (lines.is("$Entities") && four)
      readEntities(lines, mesh);
    else if (lines.is("$Nodes"))
      four ? readNodes4(lines, mesh) : readNodes2(lines, mesh);
    else if (lines.is("$Elements")) {
      four ? readElements4(lines, mesh) : readElements2(lines, mesh);
      elements = true;
    }
  }
  if (!elements)
    throw InputError(message("line ", lines.number(), ": the file has no $Elements"));
  if (mesh.lines.empty())
    throw InputError(
        "no line element belongs to a physical group; name the boundary's curves "
        "(Physical Curve(\"name\") = {...};)");
  return mesh;
}

/// The lines at every node; exactly two where the mesh is an outline.
std::map<Tag, std::vector<std::size_t>> incidence(const MeshFile& mesh) {
  std::map<Tag, std::vector<std::size_t>> result;
  std::set<std::pair<std::pair<Tag, Tag>, Tag>> pairs;
  for (std::size_t i = 0; i < mesh.lines.size(); ++i) {
    const Line& line = mesh.lines[i];
    const std::string where = message("line ", line.fileLine, ": ");
    for (const Tag node : {line.from, line.to, line.middle})
      if (mesh.nodes.count(node) == 0 && (node != line.middle || node != 0))
        throw InputError(message(where, "there is no node ", node));
    if (line.from == line.to)
      throw InputError(message(where, "an element from node ", line.from, " to itself"));
    if (!pairs.insert({std::minmax(line.from, line.to), line.middle}).second)
      throw InputError(message(where, "a second element between nodes ", line.from,
                               " and ", line.to, "; an edge has one name"));
    result[line.from].push_back(i);
    result[line.to].push_back(i);
  }
  for (const auto& [tag, touching] : result)
    if (touching.size() != 2) {
      const Vec2 place = mesh.nodes.at(tag).place;
      throw InputError(
          message("line ", mesh.lines[touching.front()].fileLine, ": at node ", tag,
                  " = (", place.x, ", ", place.y, ") ",
                  touching.size() == 1
                      ? "the outline ends; all of its curves need a physical group"
                      : message(touching.size(), " lines meet; an outline has two"),
                  " (lines without a physical group are not read)"));
    }
  return result;
}

void checkPlane(const MeshFile& mesh) {
  double least = 0;
  double most = 0;
  double size = 0;
  bool first = true;
  for (const Line& line : mesh.lines)
    for (const Tag tag : {line.from, line.to, line.middle}) {
      if (tag == 0 && tag == line.middle)
        continue;
      const Node& node = mesh.nodes.at(tag);
      least = first ? node.z : std::min(least, node.z);
      most = first ? node.z : std::max(most, node.z);
      size = std::max({size, std::abs(node.place.x), std::abs(node.place.y)});
      first = false;
    }
  if (most - least > 1e-9 * size)
    throw InputError(message(
        "the outline is not in a plane of constant z: from z = ", least, " to ", most));
}

std::string nameOf(const MeshFile& mesh, Tag group) {
  const auto name = mesh.names.find(group);
  return name == mesh.names.end() ? std::to_string(group) : name->second;
}

bem::Curve curveOf(const Loop& loop, std::size_t i) {
  return {loop.vertices[i], loop.vertices[(i + 1) % loop.vertices.size()],
          loop.bulges[i]};
}

/// tan(angle/4) of the arc through three points: half of its angle is what the chords to
/// the middle one turn by.
double bulgeThrough(Vec2 from, Vec2 middle, Vec2 to, const std::string& where) {
  const double turn =
      std::atan2(cross(middle - from, to - middle), dot(middle - from, to - middle));
  constexpr double quarterTurn = 1.5707963267948966;
  if (!(std::abs(turn) <= quarterTurn * (1 + 1e-9)))
    throw InputError(where +
                     "the middle node of a line of second order is not between its ends");
  return std::abs(turn) < straight ? 0 : std::tan(0.5 * turn);
}

double bulgeOf(const MeshFile& mesh, const Line& line, Tag from) {
  if (line.middle == 0)
    return 0;
  const Vec2 a = mesh.nodes.at(line.from).place;
  const Vec2 b = mesh.nodes.at(line.to).place;
  const double bulge = bulgeThrough(a, mesh.nodes.at(line.middle).place, b,
                                    message("line ", line.fileLine, ": "));
  return from == line.from ? bulge : -bulge;
}

double twiceArea(const Loop& loop) {
  double area = 0;
  for (std::size_t i = 0; i < loop.vertices.size(); ++i)
    area += loop.bulges[i] == 0 ? 0 : twiceAreaBesideChord(curveOf(loop, i));
  for (std::size_t i = 0; i < loop.vertices.size(); ++i)
    area += cross(loop.vertices[i] - loop.vertices[0],
                  loop.vertices[(i + 1) % loop.vertices.size()] - loop.vertices[0]);
  return area;
}

/// The same loop the other way round: edge i leads from vertex i to i+1 again.
void reverse(Loop& loop, std::vector<Tag>& tags) {
  std::reverse(loop.vertices.begin(), loop.vertices.end());
  std::reverse(tags.begin(), tags.end());
  std::reverse(loop.edges.begin(), loop.edges.end() - 1);
  std::reverse(loop.bulges.begin(), loop.bulges.end() - 1);
  for (double& bulge : loop.bulges)
    bulge = -bulge;
}

/// Does the loop turn, or change its curvature or its name, at vertex i?
bool isCorner(const Loop& loop, std::size_t i) {
  const std::size_t n = loop.vertices.size();
  const std::size_t before = (i + n - 1) % n;
  if (loop.edges[before] != loop.edges[i])
    return true;
  if (loop.bulges[before] != 0 || loop.bulges[i] != 0) {
    const bem::Curve in = curveOf(loop, before);
    const bem::Curve out = curveOf(loop, i);
    return in.isStraight() || out.isStraight() ||
           !(dot(in.tangent(1), out.tangent(-1)) > 0 &&
             std::abs(cross(in.tangent(1), out.tangent(-1))) <= oneCircle &&
             std::abs(in.curvature() - out.curvature()) <=
                 oneCircle * std::abs(in.curvature()));
  }
  const Vec2 in = loop.vertices[i] - loop.vertices[before];
  const Vec2 out = loop.vertices[(i + 1) % n] - loop.vertices[i];
  return !(dot(in, out) > 0 &&
           std::abs(cross(in, out)) <= straight * norm(in) * norm(out));
}

/// Corners only, from the one with the smallest tag on.
Loop merged(const Loop& loop, const std::vector<Tag>& tags) {
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < loop.vertices.size(); ++i)
    if (isCorner(loop, i))
      corners.push_back(i);
  const auto first = std::min_element(
      corners.begin(), corners.end(),
      [&tags](std::size_t a, std::size_t b) { return tags[a] < tags[b]; });
  const std::size_t n = loop.vertices.size();
  const std::size_t start =
      corners.empty() ? static_cast<std::size_t>(
                            std::min_element(tags.begin(), tags.end()) - tags.begin())
                      : *first;
  constexpr double halfACircle = 3.1415926535897932 * (1 + 1e-6);
  Loop result;
  double angle = 0;  // of the last edge
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = (start + k) % n;
    const double more = 4 * std::atan(loop.bulges[i]);
    if (k == 0 || isCorner(loop, i) || std::abs(angle + more) > halfACircle) {
      result.vertices.push_back(loop.vertices[i]);
      result.edges.push_back(loop.edges[i]);
      result.bulges.push_back(0);
      angle = 0;
    }
    angle += more;
    result.bulges.back() = std::tan(0.25 * angle);
  }
  if (std::all_of(result.bulges.begin(), result.bulges.end(),
                  [](double bulge) { return bulge == 0; }))
    result.bulges.clear();
  return result;
}

std::vector<Loop> chain(const MeshFile& mesh) {
  const auto touching = incidence(mesh);
  std::vector<bool> used(mesh.lines.size(), false);
  std::vector<Loop> loops;
  for (std::size_t start = 0; start < mesh.lines.size(); ++start) {
    if (used[start])
      continue;
    Loop loop;
    std::vector<Tag> tags;
    std::size_t line = start;
    Tag node = mesh.lines[start].from;
    while (!used[line]) {
      used[line] = true;
      tags.push_back(node);
      loop.vertices.push_back(mesh.nodes.at(node).place);
      loop.edges.push_back(nameOf(mesh, mesh.lines[line].group));
      loop.bulges.push_back(bulgeOf(mesh, mesh.lines[line], node));
      node = mesh.lines[line].from == node ? mesh.lines[line].to : mesh.lines[line].from;
      const auto& both = touching.at(node);
      line = both[0] == line ? both[1] : both[0];
    }
    if (twiceArea(loop) < 0)
      reverse(loop, tags);
    loops.push_back(merged(loop, tags));
  }
  return loops;
}

}  // namespace

Loops readGmsh(const std::string& text) {
  const MeshFile mesh = readFile(text);
  std::vector<Loop> loops = chain(mesh);
  checkPlane(mesh);
  for (const Loop& loop : loops)
    if (loop.vertices.size() < (loop.bulges.empty() ? 3 : 2))
      throw InputError("a loop of lines has no area");
  const auto area = [](Loop loop) {
    loop.bulges.resize(loop.vertices.size());
    return twiceArea(loop);
  };
  const auto outer =
      std::max_element(loops.begin(), loops.end(),
                       [&](const Loop& a, const Loop& b) { return area(a) < area(b); });
  Loops result{*outer, {}};
  loops.erase(outer);
  result.holes = std::move(loops);
  return result;
}

}  // namespace epafi::drivers
