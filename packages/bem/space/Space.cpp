#include "bem/space/Space.hpp"

#include "bem/basis/Legendre.hpp"
#include "bem/quadrature/Gauss.hpp"

#include <algorithm>
#include <array>

namespace epafi::bem {

Space::Space(Mesh mesh, int components)
    : mesh_(std::move(mesh)), components_(components) {
  displacementStart_.assign(1, 0);
  densityStart_.assign(1, 0);
  for (const Element& element : mesh_.elements()) {
    displacementStart_.push_back(displacementStart_.back() + components * element.degree);
    densityStart_.push_back(densityStart_.back() + components * element.densities);
  }
  if (components == 2 && mesh_.hasArcs() && !mesh_.outline().isAxisymmetric())
    rotation_ = std::make_shared<const Rotation>(*this);
}

Vec2 Space::rotationRest(int e, double t) const {
  if (mesh_.lineOf(e) >= 0 || rotation_ == nullptr)
    return {};
  return rotation_->at(mesh_.scaledPoint(e, t)) - polynomialAt(rotation_->motion(), e, t);
}

Vec2 Space::polynomialAt(const Vector& u, int e, double t) const {
  std::array<double, largestDegree + 1> phi{};
  const int p = mesh_[e].degree;
  DisplacementBasis::values(p, t, phi.data());
  Vec2 value;
  for (int k = 0; k <= p; ++k)
    value = value + phi[k] * coefficient(u, displacement(e, k, 0));
  return value;
}

Vec2 Space::densityAt(const Vector& psi, int e, double t) const {
  std::array<double, largestDegree + 1> legendre{};
  const int count = mesh_[e].densities;
  legendreValues(count - 1, t, legendre.data());
  Vec2 value;
  for (int i = 0; i < count; ++i)
    value = value + legendre[i] * coefficient(psi, density(e, i, 0));
  return value;
}

Matrix Space::rigidMotions() const {
  Matrix motions(displacements(), components_ == 1 ? 1 : 3);
  if (components_ == 1) {
    for (int e = 0; e < mesh_.size(); ++e)
      motions(displacement(e, 0, 0), 0) = 1;
    return motions;
  }
  if (mesh_.outline().isAxisymmetric()) {
    for (int e = 0; e < mesh_.size(); ++e)
      motions(displacement(e, 0, 1), 1) = 1;
    return motions;
  }
  for (int e = 0; e < mesh_.size(); ++e) {
    const Vec2 x = mesh_.scaledPoint(e, -1);
    motions(displacement(e, 0, 0), 0) = 1;
    motions(displacement(e, 0, 1), 1) = 1;
    motions(displacement(e, 0, 0), 2) = -x.y;
    motions(displacement(e, 0, 1), 2) = x.x;
  }
  if (rotation_ != nullptr)  // about the centroid, moved to the origin
    for (Index i = 0; i < motions.rows(); ++i)
      motions(i, 2) = rotation_->motion()[i] - rotation_->centre().y * motions(i, 0) +
                      rotation_->centre().x * motions(i, 1);
  return motions;
}

// Both ends, then Gauss points enough for the derivative's Legendre coefficients by
// parts:
//   ∫ v' P_k dt = [v P_k] - ∫ v P_k' dt.
std::vector<double> Space::samplePoints(int degree) const {
  std::vector<double> points = {-1, 1};
  if (degree > 1) {
    const Rule& rule = gaussLegendre(degree + 6);
    points.insert(points.end(), rule.points.begin(), rule.points.end());
  }
  return points;
}

Vector Space::interpolateSamples(const std::vector<int>& elements,
                                 const std::vector<Vec2>& samples) const {
  Vector u(displacements());
  const auto set = [&](Index first, Vec2 value) {
    u[first] = value.x;
    if (components_ == 2)
      u[first + 1] = value.y;
  };
  const Vec2* sample = samples.data();
  for (const int e : elements) {
    const int p = mesh_[e].degree;
    const Vec2 start = sample[0];
    const Vec2 end = sample[1];
    sample += 2;
    set(displacement(e, 0, 0), start);
    set(displacement(e, 1, 0), end);
    if (p == 1)
      continue;
    const Rule& rule = gaussLegendre(p + 6);
    for (int k = 2; k <= p; ++k) {
      // coefficient of P_{k-1} in v', divided by the slope of φ_k
      Vec2 integral = end - (k % 2 == 0 ? -1.0 : 1.0) * start;
      for (int q = 0; q < rule.size(); ++q) {
        std::array<double, largestDegree + 1> legendre{};
        legendreValues(k, rule.points[q], legendre.data());
        double derivative = 0;  // P_{k-1}' = Σ (2i+1) P_i,  i = k-2, k-4, ...
        for (int i = k - 2; i >= 0; i -= 2)
          derivative += (2 * i + 1) * legendre[i];
        integral = integral - rule.weights[q] * derivative * sample[q];
      }
      const double scale = (2 * k - 1) / (2 * DisplacementBasis::slope(k));
      set(displacement(e, k, 0), scale * integral);
    }
    sample += rule.size();
  }
  return u;
}

}  // namespace epafi::bem
