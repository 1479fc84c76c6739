#include "contact/multiplier/SharedNodes.hpp"

#include "bem/algebra/LeastSquares.hpp"
#include "bem/basis/Legendre.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace epafi::contact {

namespace {

using bem::Vec2;
using ContactElement = MultiplierSpace::ContactElement;
using Combination = std::vector<std::pair<Index, double>>;

/// Smallest norm of a unit direction's component orthogonal to the constrained directions
/// of a node; below, the node gets no coefficient for it, see completeEnds.
constexpr double spent = 1e-2;

/// Directions in which the displacements of nodes are constrained.
class NodeDirections {
 public:
  /// Those constrained by Dirichlet conditions.
  NodeDirections(const bem::Mesh& mesh, const Conditions& conditions) {
    for (int e = 0; e < mesh.size(); ++e) {
      const Vec2 given = conditions.given(mesh.boundary(e));
      for (const int node : {mesh[e].startNode, mesh[e].endNode}) {
        take(node, {given.x, 0});
        take(node, {0, given.y});
      }
    }
  }

  /// Do the constrained directions of the node leave less than `spent` of a unit vector?
  bool isSpent(int node, Vec2 direction) const {
    const auto taken = taken_.find(node);
    const std::vector<Vector> none;
    return bem::leastSquares(taken == taken_.end() ? none : taken->second,
                             {direction.x, direction.y}, 0)
               .rest < spent;
  }

  /// Constrains the direction unless it is spent.
  bool take(int node, Vec2 direction) {
    if (isSpent(node, direction))
      return false;
    taken_[node].push_back({direction.x, direction.y});
    return true;
  }

  bool anyAt(int node) const { return taken_.count(node) > 0; }

 private:
  std::map<int, std::vector<Vector>> taken_;
};

/// A coefficient of an element at one of its ends, in one direction.
struct EndOf {
  Coefficients* own;
  bool last;
  int node;
  Vec2 direction;
  double weight;  ///< force on the node for a unit coefficient: ∫ χ ds

  Coefficients::End& coefficient() const { return own->ends[last ? 1 : 0]; }
  bool isOwn() const { return coefficient().isUnknown; }
};

Vector legendreAt(int degree, double t) {
  Vector values(at(degree + 1));
  bem::legendreValues(degree, t, values.data());
  return values;
}

std::vector<EndOf> endsOf(const bem::Mesh& mesh, ContactElement& element) {
  const bem::Element& geometry = mesh[element.element];
  // of the Gauss-Lobatto rule at its end points
  const double weight = geometry.half * 2 / (element.degree * (element.degree + 1.0));
  std::vector<EndOf> ends;
  for (const bool last : {false, true}) {
    const int node = last ? geometry.endNode : geometry.startNode;
    const double t = last ? 1 : -1;
    ends.push_back({&element.normal, last, node, geometry.curve.normal(t), weight});
    if (element.shears())
      ends.push_back(
          {&element.tangential, last, node, geometry.curve.tangent(t), weight});
  }
  return ends;
}

/// Coefficient by endWeights minus that of the neighbour.
Combination beyondNeighbour(const EndOf& end) {
  const Coefficients& own = *end.own;
  const Vector weights = endWeights(own, end.last);
  Combination result;
  for (int i = 0; i <= own.degree; ++i)
    if (weights[i] != 0)
      result.emplace_back(own.number(i), weights[i]);
  result.emplace_back(own.number(end.last ? own.degree : 0), -1);
  return result;
}

void add(const Combination& terms, double factor, Combination& to) {
  for (const auto& [k, weight] : terms)
    if (factor * weight != 0)
      to.emplace_back(k, factor * weight);
}

/// Coefficients α of the owners with  Σ α_k weight_k direction_k = - force;  empty if there
/// are none.
Vector answer(const std::vector<EndOf>& owners, Vec2 force) {
  if (owners.size() == 2) {
    const Vec2 a = owners[0].weight * owners[0].direction;
    const Vec2 b = owners[1].weight * owners[1].direction;
    const double determinant = cross(a, b);
    if (determinant == 0)
      return {};
    return {-cross(force, b) / determinant, -cross(a, force) / determinant};
  }
  constexpr double rounding = 1e-12;
  if (owners.size() == 1 &&
      std::abs(cross(owners[0].direction, force)) <= rounding * norm(force))
    return {-dot(owners[0].direction, force) / owners[0].weight};
  return {};
}

/// Completions at a node of several contact sides.
void completeNode(const std::vector<EndOf>& ends) {
  std::vector<EndOf> owners;
  std::copy_if(ends.begin(), ends.end(), std::back_inserter(owners),
               [](const EndOf& end) { return end.isOwn(); });
  for (const EndOf& end : ends) {
    if (end.isOwn())
      continue;
    const Vector factors = answer(owners, end.weight * end.direction);
    if (factors.empty())
      continue;  // the coefficient of the neighbour stays
    const Combination change = beyondNeighbour(end);
    add(change, 1, end.coefficient().added);
    for (std::size_t k = 0; k < owners.size(); ++k)
      add(change, factors[k], owners[k].coefficient().added);
  }
}

}  // namespace

void chooseEnds(const bem::Mesh& mesh, const Conditions& conditions,
                std::vector<ContactElement>& elements) {
  std::vector<bool> joined(elements.size());  // shares its first node
  for (const ContactElement& element : elements)
    if (element.joinsFollower)
      joined[*element.follower] = true;
  NodeDirections nodes(mesh, conditions);
  for (const bool tangential : {false, true})
    for (std::size_t k = 0; k < elements.size(); ++k)
      for (EndOf& end : endsOf(mesh, elements[k]))
        if (end.own == (tangential ? &elements[k].tangential : &elements[k].normal) &&
            !(end.last ? elements[k].joinsFollower : joined[k]))
          end.coefficient().isUnknown = nodes.take(end.node, end.direction);
}

Vector endWeights(const Coefficients& own, bool last) {
  const int degree = own.degree;
  const Vector places = multiplierBasis("Biorthogonal").places(degree);
  const bool alone = !own.ends[0].isUnknown && !own.ends[1].isUnknown;
  const double sign = last ? 1 : -1;
  Vector products;  // w_i Q(x_i) up to a common factor
  for (const double x : places) {
    const Vector legendre = legendreAt(degree, x);
    const double q = legendre[degree] + (alone ? sign * legendre[degree - 1] : 0.0);
    products.push_back(q / (legendre[degree] * legendre[degree]));
  }
  const int end = last ? degree : 0;
  const double product = products[end];
  for (int i = 0; i <= degree; ++i)
    products[i] = own.isOwn(i) ? -products[i] / product : 0;
  return products;
}

void completeEnds(const bem::Mesh& mesh, const Conditions& conditions,
                  std::vector<ContactElement>& elements) {
  const NodeDirections clamped(mesh, conditions);
  std::map<int, std::vector<EndOf>> nodes;
  for (ContactElement& element : elements)
    for (const EndOf& end : endsOf(mesh, element)) {
      if (!clamped.anyAt(end.node)) {
        nodes[end.node].push_back(end);
      } else if (!end.isOwn() && clamped.isSpent(end.node, end.direction)) {
        end.coefficient().clamped = true;
        add(beyondNeighbour(end), 1, end.coefficient().added);
      }
    }
  for (const auto& [node, ends] : nodes)
    if (std::any_of(ends.begin(), ends.end(),
                    [](const EndOf& end) { return !end.isOwn(); }))
      completeNode(ends);
}

}  // namespace epafi::contact
