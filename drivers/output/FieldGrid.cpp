#include "drivers/output/FieldGrid.hpp"

#include "contact/problem/ContactFields.hpp"

#include <algorithm>
#include <limits>

namespace epafi::drivers {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

int linesOf(const bem::Element& element) { return 2 * (element.degree + 1); }

int numberOf(contact::FrictionKind friction) {
  switch (friction) {
    case contact::FrictionKind::Stick:
      return 1;
    case contact::FrictionKind::Slip:
      return 2;
    case contact::FrictionKind::None:
      break;
  }
  return 0;
}

void add(bem::Vec2 vector, Slice<double>& slice) {
  slice.mine.insert(slice.mine.end(), {vector.x, vector.y, 0});
}

/// Fills a grid element by element.
class Sampler {
 public:
  Sampler(const contact::Solved& solved, const bem::Vector& density)
      : solved_(solved),
        density_(density),
        names_(boundaryNames(mesh().outline())),
        fields_(solved.problem, solved.space, solved.units, solved.state,
                solved.displacement),
        contacts_(static_cast<std::size_t>(mesh().size()), nullptr) {
    for (const auto& element : fields_.elements())
      contacts_[static_cast<std::size_t>(element.element)] = &element;
  }

  /// `first`: number of its first point.
  void sample(int e, long long first, FieldGrid& grid) const {
    const bem::Element& element = mesh()[e];
    const int lines = linesOf(element);
    for (int k = 0; k <= lines; ++k)
      samplePoint(e, -1 + 2.0 * k / lines, grid);
    const auto name = std::find(names_.begin(), names_.end(), mesh().boundary(e));
    const auto boundary = static_cast<int>(name - names_.begin());
    for (int k = 0; k < lines; ++k) {
      grid.ends.mine.insert(grid.ends.mine.end(), {first + k, first + k + 1});
      grid.element.mine.push_back(e);
      grid.degree.mine.push_back(element.degree);
      grid.boundary.mine.push_back(boundary);
    }
  }

 private:
  const bem::Mesh& mesh() const { return solved_.space.mesh(); }

  void samplePoint(int e, double t, FieldGrid& grid) const {
    add(mesh().physicalPoint(e, t), grid.points);
    add(solved_.units.length * solved_.space.displacementAt(solved_.displacement, e, t),
        grid.displacement);
    add(solved_.units.stress * solved_.space.densityAt(density_, e, t), grid.traction);
    contact::ContactPoint point;
    point.pressure = point.shear = point.gap = nothing;
    const auto* contact = contacts_[static_cast<std::size_t>(e)];
    if (contact != nullptr)
      point = fields_.at(*contact, t);
    grid.pressure.mine.push_back(point.pressure);
    grid.shear.mine.push_back(point.shear);
    grid.gap.mine.push_back(point.gap);
    grid.contact.mine.push_back(contact == nullptr ? -1 : (point.closed ? 1 : 0));
    grid.friction.mine.push_back(contact == nullptr ? -1 : numberOf(point.friction));
  }

  const contact::Solved& solved_;
  const bem::Vector& density_;
  std::vector<std::string> names_;
  contact::ContactFields fields_;
  std::vector<const contact::ContactFields::Element*> contacts_;
};

template <class T>
void place(long long rows, long long first, long long columns, Slice<T>& slice) {
  slice.rows = rows;
  slice.first = first;
  slice.columns = columns;
}

}  // namespace

FieldGrid fieldGrid(const contact::Solved& solved, const bem::Vector& density,
                    const bem::DenseAlgebra& algebra) {
  const bem::Mesh& mesh = solved.space.mesh();
  const bem::Rows mine = algebra.myRows(mesh.size());
  const Sampler sampler(solved, density);
  FieldGrid grid;
  long long lines = 0;
  long long firstLine = 0;
  for (int e = 0; e < mesh.size(); ++e) {
    if (e == mine.begin)
      firstLine = lines;
    if (mine.contain(e))
      sampler.sample(e, lines + e, grid);  // one point more than lines per element
    lines += linesOf(mesh[e]);
  }
  const long long points = lines + mesh.size();
  const long long firstPoint = firstLine + mine.begin;
  for (auto* vectors : {&grid.points, &grid.displacement, &grid.traction})
    place(points, firstPoint, 3, *vectors);
  for (auto* numbers : {&grid.pressure, &grid.shear, &grid.gap})
    place(points, firstPoint, 1, *numbers);
  for (auto* states : {&grid.contact, &grid.friction})
    place(points, firstPoint, 1, *states);
  place(2 * lines, 2 * firstLine, 1, grid.ends);
  for (auto* numbers : {&grid.element, &grid.degree, &grid.boundary})
    place(lines, firstLine, 1, *numbers);
  return grid;
}

std::vector<std::string> boundaryNames(const bem::Outline& outline) {
  std::vector<std::string> names;
  for (const bem::Edge& edge : outline.edges())
    if (std::find(names.begin(), names.end(), edge.boundary) == names.end())
      names.push_back(edge.boundary);
  return names;
}

}  // namespace epafi::drivers
