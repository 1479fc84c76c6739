#include "bem/compressed/CompressedOperators.hpp"

#include "bem/algebra/Products.hpp"
#include "bem/base/BlasThreads.hpp"
#include "bem/compressed/BodyShare.hpp"
#include "bem/compressed/ClusterOrder.hpp"
#include "bem/compressed/TreeSweeps.hpp"
#include "bem/mesh/Surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace epafi::bem {

namespace {

/// All unknowns of all bodies.
struct AllUnknowns {
  std::vector<BodyShare> shares;
  std::vector<std::pair<std::size_t, Index>> owners;  ///< whose, and which of its own

  explicit AllUnknowns(std::size_t bodies) : shares(bodies) {}

  void add(std::size_t b, const Unknown& unknown) {
    owners.emplace_back(b, static_cast<Index>(shares[b].unknowns.size()));
    shares[b].numbers.push_back(static_cast<Index>(owners.size()) - 1);
    shares[b].unknowns.push_back(unknown);
  }

  BodyElement elementOf(Index unknown) const {
    const auto [b, own] = owners[unknown];
    return {static_cast<int>(b), shares[b].unknowns[own].element};
  }

  /// Gives bodies the entries between their own unknowns; returns those between bodies.  `across`:
  /// these and those between elements of one body that do not touch, as where it meets itself.
  std::vector<Entry> shareOut(const std::vector<const Space*>& spaces,
                              const std::vector<Entry>& entries,
                              std::vector<Entry>& across) {
    std::vector<Entry> between;
    for (const Entry& entry : entries) {
      const auto [b, row] = owners[entry.row];
      const auto [d, column] = owners[entry.column];
      if (b != d || !areBeside(spaces[b]->mesh(), shares[b].unknowns[at(row)].element,
                               shares[b].unknowns[at(column)].element))
        across.push_back(entry);
      if (b == d)
        shares[b].entries.push_back({row, column, entry.value});
      else
        between.push_back(entry);
    }
    return between;
  }

  static bool areBeside(const Mesh& mesh, int e, int f) {
    return e == f || mesh[e].next == f || mesh[e].previous == f;
  }

  std::vector<Link> linksOf(const std::vector<Entry>& across) const {
    std::vector<Link> links;
    links.reserve(across.size());
    for (const Entry& entry : across)
      links.push_back({elementOf(std::max(entry.row, entry.column)),
                       elementOf(std::min(entry.row, entry.column)),
                       std::abs(entry.value)});
    return links;
  }

  /// `leaves`: of all unknowns.
  void setAbroad(const std::vector<Entry>& across, const std::vector<int>& leaves) {
    for (BodyShare& share : shares)
      share.abroad.resize(share.unknowns.size());
    for (const Entry& entry : across)
      for (const auto& [i, j] :
           {std::pair(entry.row, entry.column), std::pair(entry.column, entry.row)}) {
        const auto [b, own] = owners[i];
        std::vector<int>& abroad = shares[b].abroad[own];
        if (std::find(abroad.begin(), abroad.end(), leaves[j]) == abroad.end())
          abroad.push_back(leaves[j]);
      }
  }
};

}  // namespace

CompressedOperators::CompressedOperators(const std::vector<Body>& bodies,
                                         const Compression& options,
                                         const LocalCoupling& local,
                                         const Processes& processes)
    : local_(local) {
  const BlasThreads serial(1);
  std::vector<const Space*> spaces;
  AllUnknowns all(bodies.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const Space& space = bodies[b].space;
    const auto first = static_cast<Index>(all.owners.size());
    ranges_.push_back({first, first + space.displacements(),
                       first + space.displacements() + space.densities(),
                       bodies[b].kernel->stiffness()});
    spaces.push_back(&space);
    if (surfacesOf(space.mesh()).size() > 1)
      for (const Index i : bodies[b].kernel->resting(space))
        springUnknowns_.push_back(first + i);
    for (const Unknown& unknown : unknownsOf(space))
      all.add(b, unknown);
  }
  for (std::size_t k = 0; k < local.elements.size(); ++k)
    all.add(local.bodies.empty() ? 0 : local.bodies[k], {local.elements[k], -1, true});
  std::vector<Entry> across;
  const auto between = all.shareOut(spaces, local.entries, across);
  const std::vector<ClusterPlace> order = clusterOrder(spaces, all.linksOf(across));
  for (std::size_t b = 0; b < bodies.size(); ++b)
    trees_.emplace_back(spaces, order, static_cast<int>(b), options.leafUnknowns);
  std::vector<Index> unknowns(tree().size());
  for (std::size_t i = 0; i < all.owners.size(); ++i) {
    const BodyElement place = all.elementOf(static_cast<Index>(i));
    leaves_.push_back(trees_[place.body].leafOf(place.element));
    for (int c = leaves_.back(); c >= 0; c = tree()[c].parent)
      ++unknowns[c];
  }
  subtrees_ = std::make_unique<const Subtrees>(tree(), unknowns, processes);
  // what is missed of a rigid motion adds up over the unknowns
  constexpr double many = 65536;
  Compression accurate = options;
  accurate.tolerance *= std::min(1.0, many / static_cast<double>(size()));
  all.setAbroad(across, leaves_);
  for (std::size_t b = 0; b < bodies.size(); ++b)
    skeletonise(all.shares[b], bodies[b].space, *bodies[b].kernel, trees_[b], accurate,
                *subtrees_);
  parts_ = all.shares.size() == 1
               ? std::move(all.shares.front().parts)
               : joined(std::move(all.shares), between, tree(), *subtrees_, size());
  takeTranslations(bodies);
  addRotations(bodies);
}

// What interpolation misses of a translation is of one sign along a whole body: 1e-12 of W's entries
// add up to forces of 1e-9 of the largest at 1e5 elements, and those of K to forces that are 1e-11 of
// stresses times area.  A node's own block takes it in its leaf, and those of an element's other functions
// and densities with its first node.  Between the components one half is taken: the
// rest is antisymmetric, and its sum over the nodes vanishes with Z's symmetry.  Around an axis, with the one
// translation along it, all is taken.
void CompressedOperators::takeTranslations(const std::vector<Body>& bodies) {
  const int components = bodies.front().kernel->components();
  const bool isAround =
      components == 2 && bodies.front().space.mesh().outline().isAxisymmetric();
  Matrix translations(size(), components);
  std::vector<Index> nodes(at(size()), -1);  // of the element and the component
  std::vector<int> component(at(size()));
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (int e = 0; e < bodies[b].space.mesh().size(); ++e)
      for (int c = 0; c < components; ++c) {
        const Space& space = bodies[b].space;
        const Index node = ranges_[b].first + space.displacement(e, 0, c);
        translations(node, c) = isAround && c == 0 ? 0 : 1;
        for (int k = 0; k <= space.mesh()[e].degree; ++k)
          if (k != 1) {
            const Index own = ranges_[b].first + space.displacement(e, k, c);
            nodes[at(own)] = node;
            component[at(own)] = c;
          }
        for (int k = 0; k < space.mesh()[e].densities; ++k) {
          const Index own = ranges_[b].densities + space.density(e, k, c);
          nodes[at(own)] = node;
          component[at(own)] = c;
        }
      }
  Matrix left = times(translations);
  for (Index i = 0; i < size() && isAround; ++i)
    if (nodes[at(i)] == i && component[at(i)] == 0)
      left(i + 1, 0) = left(i, 1);
  std::vector<Index> places(at(size()));
  for (int c = 0; c < tree().size(); ++c) {
    ClusterPart& leaf = parts_[at(c)];
    if (!tree()[c].isLeaf() || leaf.block.rows() == 0)
      continue;
    for (std::size_t i = 0; i < leaf.active.size(); ++i)
      places[at(leaf.active[i])] = static_cast<Index>(i);
    for (const Index i : leaf.active) {
      const Index node = nodes[at(i)];
      if (node < 0)
        continue;
      const Index first = node - component[at(i)];
      const Index row = places[at(i)];
      for (int k = 0; k < components; ++k) {
        const Index column = places[at(first + k)];
        if (node == i)
          leaf.block(row, column) -=
              0.5 * (left(i, k) + left(first + k, component[at(i)]));
        else {
          leaf.block(row, column) -= left(i, k);
          leaf.block(column, row) -= left(i, k);
        }
      }
    }
  }
}

void CompressedOperators::addRotations(const std::vector<Body>& bodies) {
  std::vector<std::size_t> curved;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (bodies[b].space.rotation() != nullptr)
      curved.push_back(b);
  const auto count = static_cast<Index>(curved.size());
  if (count == 0)
    return;
  Matrix u(size(), 2 * count);
  Matrix kappa(count, count);
  for (Index k = 0; k < count; ++k) {
    const std::size_t b = curved[k];
    const Range& own = ranges_[b];
    const Rotation& rotation = *bodies[b].space.rotation();
    const Vector& r = rotation.motion();
    const Vector& q = rotation.functional();
    Matrix x(size(), 1);
    std::copy(r.begin(), r.end(), x.data() + own.first);
    const Matrix image = times(x);
    std::copy(q.begin(), q.end(), u.column(k) + own.first);
    double* const w = u.column(count + k);
    std::copy(image.data() + own.first, image.data() + own.last, w + own.first);
    kappa(k, k) = std::inner_product(r.begin(), r.end(), w + own.first, 0.0);
    if (!local_.rotations.empty())
      std::transform(local_.rotations[b].begin(), local_.rotations[b].end(),
                     w + further(), std::negate<>());
  }
  rotations_ = LowRank(std::move(u), kappa);
}

// Upwards what leaves each cluster, downwards what comes to it from outside.
Matrix CompressedOperators::times(const Matrix& x) const {
  const BlasThreads serial(1);
  const Index columns = x.columns();
  Matrix result(x.rows(), columns);
  std::vector<Matrix> out(parts_.size());
  std::vector<Matrix> in(parts_.size());
  const auto active = [&](int c) {
    const Cluster& cluster = tree()[c];
    return cluster.isLeaf() ? rowsOf(x, part(c).active)
                            : stacked(out[cluster.children[0]], out[cluster.children[1]]);
  };
  const auto up = [&](int c) {
    if (c > 0)
      out[c] = part(c).weights.times(active(c));
  };
  const auto down = [&](int c) {
    const ClusterPart& own = part(c);
    Matrix all(static_cast<Index>(own.active.size()), columns);
    if (c > 0)
      own.weights.addTransposed(in[c], all);
    if (tree()[c].isLeaf()) {
      addProduct(1, own.block, rowsOf(x, own.active), all);
      putRows(all, own.active, result);
      return;
    }
    const std::size_t first = tree()[c].children[0];
    const std::size_t second = tree()[c].children[1];
    in[first] = rowsBetween(all, 0, out[first].rows()).copy();
    in[second] = rowsBetween(all, out[first].rows(), all.rows()).copy();
    addProduct(1, own.block, out[second], in[first]);
    addTransposedProduct(1, own.block, out[first], in[second]);
  };
  const std::vector<char> everywhere(parts_.size(), 1);
  const double check = subtrees_->isAlone() ? 0 : checkOf(x);
  const auto work = [&](int c) { return part(c).sweepWork(columns); };
  upwards(tree(), *subtrees_, everywhere, work, up, [&] {
    subtrees_->exchangeRoots(
        everywhere, check, [&](int c) { return skeletonOf(c); }, columns, out);
  });
  downwards(tree(), *subtrees_, everywhere, work, down);
  exchangeRows(everywhere, check, result);
  rotations_.addTo(result, x);
  return result;
}

std::size_t CompressedOperators::bytes() const {
  std::size_t entries = 0;
  for (const ClusterPart& part : parts_)
    entries += static_cast<std::size_t>(part.weights.weights.rows() *
                                            part.weights.weights.columns() +
                                        part.block.rows() * part.block.columns());
  return entries * sizeof(double);
}

}  // namespace epafi::bem
