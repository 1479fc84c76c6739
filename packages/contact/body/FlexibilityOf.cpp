// The sum of what bodies make of D.
#include "contact/body/ElasticBody.hpp"
#include "contact/problem/BodyFlexibility.hpp"

#include <utility>

namespace epafi::contact {

namespace {

/// The upper triangle from the lower one.
void mirror(Matrix& d) {
  for (Index j = 0; j < d.columns(); ++j)
    for (Index i = j + 1; i < d.rows(); ++i)
      d(j, i) = d(i, j);
}

}  // namespace

Flexibility flexibilityOf(const std::vector<std::shared_ptr<const ElasticBody>>& bodies,
                          const std::vector<std::vector<Vector>>& motions,
                          const std::vector<std::vector<Vector>>& reactions) {
  std::vector<std::vector<Index>> columns;
  for (const auto& body : bodies)
    columns.push_back(body->coupling().columns());
  const auto size = static_cast<Index>(bodies.front()->coupling().trace.rests.size());
  const bool isSparse = BodyFlexibility::isSparse(size, columns);
  std::vector<BodyFlexibility::Part> parts;
  Matrix whole(isSparse ? 0 : size, isSparse ? 0 : size);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const auto count = static_cast<Index>(columns[b].size());
    Matrix entries(count, count);
    const auto exchange = [&](const auto& action) {
      for (Index j = 0; j < count && !isSparse; ++j)
        for (Index i = j; i < count; ++i)
          action(entries(i, j), whole(columns[b][at(i)], columns[b][at(j)]));
    };
    exchange([](double& own, double so) { own = so; });
    entries = bodies[b]->addCompliance(std::move(entries), motions[b], reactions[b]);
    exchange([](double own, double& sum) { sum = own; });
    if (!isSparse)
      continue;
    mirror(entries);
    parts.push_back({std::move(columns[b]), std::move(entries)});
  }
  mirror(whole);
  if (isSparse)
    return Flexibility(std::make_shared<const BodyFlexibility>(size, std::move(parts)));
  return whole;
}

}  // namespace epafi::contact
