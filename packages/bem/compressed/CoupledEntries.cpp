#include "bem/compressed/CoupledEntries.hpp"

#include <map>

namespace epafi::bem {

std::vector<ElementFunctions> byElements(const Space& space,
                                         const std::vector<Unknown>& unknowns,
                                         const std::vector<Index>& which) {
  std::map<int, ElementFunctions> found;
  const auto add = [&](int element, int local, std::size_t place) {
    if (!space.mesh().isAxis(element))
      found[element].functions.emplace_back(local, static_cast<Index>(place));
  };
  for (std::size_t i = 0; i < which.size(); ++i) {
    const Unknown& unknown = unknowns[which[i]];
    if (unknown.local < 0)
      continue;
    add(unknown.element, unknown.local, i);
    if (unknown.isNode)
      add(space.mesh()[unknown.element].previous, unknown.local + space.components(), i);
  }
  std::vector<ElementFunctions> result;
  result.reserve(found.size());
  for (auto& [element, own] : found)
    result.push_back({element, std::move(own.functions)});
  return result;
}

CoupledEntries::CoupledEntries(const Space& space, const Kernel& kernel,
                               const NearBlocks& near,
                               const std::vector<Unknown>& unknowns)
    : space_(space), near_(near), unknowns_(unknowns), far_(kernel.far(space)) {}

Matrix CoupledEntries::operator()(const std::vector<Index>& rows,
                                  const std::vector<Index>& columns) {
  Matrix out(static_cast<Index>(rows.size()), static_cast<Index>(columns.size()));
  const std::vector<ElementFunctions> tests = byElements(space_, unknowns_, rows);
  for (const ElementFunctions& column : byElements(space_, unknowns_, columns))
    addColumn(tests, 0, column, out);
  return out;
}

// Pairs of an element with itself and with those behind it; the others mirror them.
Matrix CoupledEntries::symmetric(const std::vector<Index>& unknowns) {
  const auto n = static_cast<Index>(unknowns.size());
  Matrix own(n, n);
  Matrix out(n, n);
  const std::vector<ElementFunctions> wanted = byElements(space_, unknowns_, unknowns);
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const NearBlocks::View block = near_.of(wanted[k].element, wanted[k].element);
    for (const auto& [b, column] : wanted[k].functions)
      for (const auto& [a, row] : wanted[k].functions)
        own(row, column) += block(a, b);
    addColumn(wanted, k + 1, wanted[k], out);
  }
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i <= j; ++i) {
      const double sum = out(i, j) + out(j, i);
      out(i, j) = sum + own(i, j);
      out(j, i) = out(i, j);
    }
  return out;
}

void CoupledEntries::addColumn(const std::vector<ElementFunctions>& rows,
                               std::size_t first, const ElementFunctions& column,
                               Matrix& out) {
  const int f = column.element;
  std::vector<const ElementFunctions*> waiting;
  const auto flush = [&] {
    if (!waiting.empty())
      addTests(waiting, column, out);
    waiting.clear();
    tests_.clear();
  };
  for (std::size_t k = first; k < rows.size(); ++k) {
    const int e = rows[k].element;
    const Vec2 w = near_.offset(e, f);
    if (!near_.isFullyFar(e, f, w)) {
      const NearBlocks::View block = near_.of(e, f);
      for (const auto& [b, place] : column.functions)
        for (const auto& [a, row] : rows[k].functions)
          out(row, place) += block(a, b);
      continue;
    }
    waiting.push_back(&rows[k]);
    tests_.push_back({e, w});
    if (tests_.size() == lanes)
      flush();
  }
  flush();
}

void CoupledEntries::addTests(const std::vector<const ElementFunctions*>& rows,
                              const ElementFunctions& column, Matrix& out) {
  far_->evaluate(tests_, column.element);
  for (std::size_t t = 0; t < rows.size(); ++t) {
    const int displacements = LocalFunctions(space_, rows[t]->element).displacements;
    const int shift = far_->densities() - displacements;
    for (const auto& [b, place] : column.functions) {
      double* to = out.column(place);
      for (const auto& [a, row] : rows[t]->functions)
        to[row] += far_->lane(a < displacements ? a : a + shift, b)[t];
    }
  }
}

}  // namespace epafi::bem
