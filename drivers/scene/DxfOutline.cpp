#include "bem/base/Error.hpp"
#include "drivers/scene/OutlineChain.hpp"
#include "drivers/scene/Text.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

namespace epafi::drivers {

namespace {

using bem::InputError;
using bem::Vec2;

constexpr double pi = boost::math::constants::pi<double>();

/// A group of a DXF file: a line with the group code, and a line with the value.
struct Pair {
  int code = 0;
  std::string value;
  int fileLine = 0;
};

/// An entity: it begins with a group of code 0.
struct Entity {
  std::string kind;
  int fileLine = 0;
  std::vector<Pair> pairs;

  const Pair* find(int code) const {
    const auto found = std::find_if(pairs.begin(), pairs.end(),
                                    [=](const Pair& pair) { return pair.code == code; });
    return found == pairs.end() ? nullptr : &*found;
  }
};

double numberOf(const Pair& pair) {
  if (const auto value = finiteIn(pair.value))
    return *value;
  throw InputError("line ", pair.fileLine, ": '", pair.value,
                   "' is not a finite number (group ", pair.code, ")");
}

double numberAt(const Entity& entity, int code) {
  if (const Pair* pair = entity.find(code))
    return numberOf(*pair);
  throw InputError("line ", entity.fileLine, ": ", entity.kind, " has no group ", code);
}

double numberAt(const Entity& entity, int code, double otherwise) {
  return entity.find(code) == nullptr ? otherwise : numberAt(entity, code);
}

/// The next group of the file; nothing at its end.
std::optional<Pair> nextPair(std::istringstream& file, int& line) {
  std::string code;
  std::string value;
  if (!std::getline(file, code))
    return std::nullopt;
  ++line;
  const auto number = numberIn<int>(trimmed(code));
  if (!number)
    throw InputError("line ", line, ": '", trimmed(code),
                     "' is not a group code; this is not a drawing in ASCII DXF");
  if (!std::getline(file, value))
    throw InputError("line ", line, ": the file ends where a value should follow");
  ++line;
  return Pair{*number, trimmed(value), line};
}

/// The entities of the section ENTITIES.
std::vector<Entity> readEntities(const std::string& text) {
  std::istringstream file(text);
  std::vector<Entity> all;
  int line = 0;
  std::string section;
  bool found = false;
  while (const auto pair = nextPair(file, line)) {
    if (pair->code == 0 && pair->value == "ENDSEC")
      section.clear();
    if (pair->code == 2 && section == "SECTION") {
      section = pair->value;
      found = found || section == "ENTITIES";
    } else if (pair->code == 0 && pair->value == "SECTION")
      section = "SECTION";
    else if (section == "ENTITIES" && pair->code == 0)
      all.push_back({pair->value, pair->fileLine, {}});
    else if (section == "ENTITIES" && !all.empty())
      all.back().pairs.push_back(*pair);
  }
  if (!found)
    throw InputError("line ", line, ": the file has no section ENTITIES");
  return all;
}

/// Collects entities as pieces of an outline and merges their ends to nodes.
class Drawing {
 public:
  /// An old POLYLINE is followed by its VERTEX entities and SEQEND.
  explicit Drawing(const std::vector<Entity>& entities) {
    for (std::size_t i = 0; i < entities.size(); ++i) {
      const Entity& entity = entities[i];
      if (numberAt(entity, 67, 0) != 0)  // in paper space
        continue;
      mirrored_ = entity.kind != "LINE" && numberAt(entity, 230, 1) < 0;
      if (entity.kind == "LINE")
        add(entity, {numberAt(entity, 10), numberAt(entity, 20)},
            {numberAt(entity, 11), numberAt(entity, 21)}, 0);
      else if (entity.kind == "ARC")
        addArc(entity, numberAt(entity, 50), numberAt(entity, 51));
      else if (entity.kind == "CIRCLE")
        addArc(entity, 0, 360);
      else if (entity.kind == "LWPOLYLINE")
        addPolyline(entity, entity.pairs);
      else if (entity.kind == "POLYLINE") {
        std::vector<Pair> vertices;
        for (; i + 1 < entities.size() && entities[i + 1].kind == "VERTEX"; ++i)
          for (const Pair& pair : entities[i + 1].pairs)
            vertices.push_back(pair);
        addPolyline(entity, vertices);
      } else
        checkIsNoCurve(entity);
    }
    if (ends_.empty())
      throw InputError(
          "the drawing has no lines, arcs, circles or polylines in model space");
  }

  OutlinePieces outline() const {
    OutlinePieces result;
    result.advice =
        "lines, arcs and polylines of all layers must close, so that construction lines "
        "are to be deleted, or left out by Geometry->Boundaries (ends closer than 1e-6 "
        "of "
        "the drawing's size are one corner)";
    result.pieces = pieces_;
    double size = 0;
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      const Vec2 end = ends_[i];
      size = std::max({size, std::abs(end.x - ends_[0].x), std::abs(end.y - ends_[0].y)});
      const auto tag = static_cast<NodeTag>(i) + 1;
      result.nodes[tag] = end;
      OutlinePiece& piece = result.pieces[i / 2];
      (i % 2 == 0 ? piece.from : piece.to) = tag;
    }
    result.same = std::max(1e-6 * size, std::numeric_limits<double>::min());
    return result;
  }

 private:
  static void checkIsNoCurve(const Entity& entity) {
    for (const char* kind : {"SPLINE", "ELLIPSE", "INSERT", "MLINE", "REGION"})
      if (entity.kind == kind)
        throw InputError(
            "line ", entity.fileLine, ": ", entity.kind,
            " is not read; explode it, or draw lines, arcs, circles and polylines");
  }

  void add(const Entity& entity, Vec2 from, Vec2 to, double bulge) {
    const Pair* layer = entity.find(8);
    if (layer != nullptr && !whyNoName(layer->value).empty())
      throw InputError("line ", layer->fileLine, ": ", whyNoName(layer->value));
    pieces_.push_back({0, 0, mirrored_ ? -bulge : bulge,
                       layer == nullptr ? "0" : layer->value, entity.fileLine});
    for (const Vec2 end : {from, to})
      ends_.push_back({mirrored_ ? -end.x : end.x, end.y});
  }

  /// Adds the arc counter-clockwise between two angles [degrees]; two pieces if it is
  /// more than half a circle.
  void addArc(const Entity& entity, double from, double to) {
    const Vec2 center{numberAt(entity, 10), numberAt(entity, 20)};
    const double radius = numberAt(entity, 40);
    if (!(radius > 0))
      throw InputError("line ", entity.fileLine, ": ", entity.kind, " has radius ",
                       radius);
    double angle = std::fmod(to - from, 360);
    if (angle <= 0)
      angle += 360;
    const int parts = angle > 180 ? 2 : 1;
    const auto at = [&](int part) {
      const double degrees = std::fmod(from + part * angle / parts, 360);
      return center +
             radius * Vec2{std::cos(degrees * pi / 180), std::sin(degrees * pi / 180)};
    };
    for (int part = 0; part < parts; ++part)
      add(entity, at(part), at(part + 1), std::tan(angle / parts * pi / 720));
  }

  /// A vertex begins with its x; its bulge belongs to the edge to the next vertex.
  void addPolyline(const Entity& entity, const std::vector<Pair>& pairs) {
    struct Vertex {
      Vec2 place;
      double bulge = 0;
    };
    std::vector<Vertex> vertices;
    for (const Pair& pair : pairs) {
      if (pair.code == 10)
        vertices.push_back({{numberOf(pair), 0}});
      else if (pair.code == 20 && !vertices.empty())
        vertices.back().place.y = numberOf(pair);
      else if (pair.code == 42 && !vertices.empty())
        vertices.back().bulge = numberOf(pair);
    }
    const bool closed = std::fmod(numberAt(entity, 70, 0), 2) == 1;  // the lowest bit
    for (std::size_t i = 0; i + (closed ? 0 : 1) < vertices.size(); ++i)
      add(entity, vertices[i].place, vertices[(i + 1) % vertices.size()].place,
          vertices[i].bulge);
  }

  bool mirrored_ = false;   ///< the current entity has the normal -z: x is mirrored
  std::vector<Vec2> ends_;  ///< two end points for each piece
  std::vector<OutlinePiece> pieces_;
};

}  // namespace

bem::Loops readDxf(const std::string& text, const FilePart& part) {
  if (!part.surface.empty())
    throw InputError(
        "a drawing has no physical surfaces; Boundaries names a body's layers");
  return chained(Drawing(readEntities(text)).outline(), part);
}

}  // namespace epafi::drivers
