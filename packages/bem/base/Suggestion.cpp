#include "bem/base/Suggestion.hpp"

#include "bem/base/Error.hpp"

#include <algorithm>
#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/predicate.hpp>
#include <limits>
#include <numeric>
#include <utility>

namespace epafi::bem {

int editDistance(const std::string& a, const std::string& b) {
  std::vector<int> row(b.size() + 1);  // of what is read of a, to each beginning of b
  std::iota(row.begin(), row.end(), 0);
  for (const char c : a) {
    int before = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const int replaced = before + (c == b[j] ? 0 : 1);
      before = row[j + 1];
      row[j + 1] = std::min({before + 1, row[j] + 1, replaced});
    }
  }
  return row.back();
}

namespace {

/// What other programs and books call it, in small letters, and its name here.
constexpr std::pair<const char*, const char*> otherWords[] = {
    {"e", "Young's Modulus"},
    {"youngs modulus", "Young's Modulus"},
    {"nu", "Poisson's Ratio"},
    {"poisson", "Poisson's Ratio"},
    {"rho", "Density"},
    {"alpha", "Thermal Expansion"},
    {"ux", "Displacement X"},
    {"uy", "Displacement Y"},
    {"u1", "Displacement X"},
    {"u2", "Displacement Y"},
    {"fx", "Force X"},
    {"fy", "Force Y"},
    {"torque", "Moment"},
    {"fixed", "Dirichlet"},
    {"clamped", "Dirichlet"},
    {"clamp", "Dirichlet"},
    {"encastre", "Dirichlet"},
    {"displacement", "Dirichlet"},
    {"support", "Dirichlet"},
    {"roller", "Dirichlet"},
    {"force", "Neumann"},
    {"traction", "Neumann"},
    {"pressure", "Neumann"},
    {"load", "Neumann"},
    {"free", "Neumann"},
    {"load", "Force Y"},
    {"frictionless", "None"},
    {"smooth", "None"},
    {"rough", "Tied"},
    {"bonded", "Tied"},
    {"glued", "Tied"},
    {"tie", "Tied"},
    {"mu", "Coefficient"},
    {"f", "Coefficient"},
    {"time", "History"},
    {"step", "History"},
    {"steps", "History"},
    {"elements", "Mesh Size"},
    {"element size", "Mesh Size"},
    {"mesh", "Discretization"},
    {"order", "Degree"},
    {"p", "Degree"},
    {"clearance", "Gap"},
    {"radius", "Bulges"},
    {"overlap", "Interference"},
    {"hp", "Graded hp"},
    {"solve", "run"},
    {"-o", "--output"},
    {"-f", "--force"},
    {"-t", "--threads"},
    {"cosine", "cos"},
    {"sine", "sin"},
    {"arcsin", "asin"},
    {"arctan", "atan"},
    {"fabs", "abs"},
    {"format", "Fields"},
    {"accuracy", "Tolerance"},
};

/// The candidate that a word of other programs stands for; null if there is none.
const std::string* otherwise(const std::string& name,
                             const std::vector<std::string>& candidates) {
  const std::string word = boost::algorithm::to_lower_copy(name);
  for (const auto& [theirs, ours] : otherWords)
    if (word == theirs)
      if (const auto found = std::find(candidates.begin(), candidates.end(), ours);
          found != candidates.end())
        return &*found;
  return nullptr;
}

/// How many letters of a name are wrong, capitals aside; of some letters the ones before may be
/// missing, as the body's of a side.
int mistakes(const std::string& name, const std::string& candidate) {
  constexpr std::size_t some = 3;
  return name.size() >= some && boost::algorithm::ends_with(candidate, name)
             ? 0
             : editDistance(boost::algorithm::to_lower_copy(name),
                            boost::algorithm::to_lower_copy(candidate));
}

}  // namespace

std::string nearest(const std::string& name, const std::vector<std::string>& candidates) {
  std::string best;
  int smallest = std::numeric_limits<int>::max();
  for (const std::string& candidate : candidates) {
    const int distance = mistakes(name, candidate);
    if (distance < smallest) {
      smallest = distance;
      best = candidate;
    }
  }
  return best;
}

std::string meant(const std::string& name, const std::vector<std::string>& candidates) {
  if (const std::string* meant = otherwise(name, candidates); meant != nullptr)
    return "; did you mean '" + *meant + "'?";
  const std::string near = nearest(name, candidates);
  return 2 * mistakes(name, near) <= static_cast<int>(name.size())
             ? "; did you mean '" + near + "'?"
             : "";
}

std::string quotedList(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0                  ? ""
             : i + 1 == names.size() ? " or "
                                     : ", ") +
            ("'" + names[i] + "'");
  return text;
}

std::string suggestion(const std::string& name,
                       const std::vector<std::string>& candidates) {
  if (candidates.empty())
    return "; nothing may stand here";
  return meant(name, candidates) + "; known here: " + quotedList(candidates);
}

}  // namespace epafi::bem
