#pragma once

#include "adaptivity/estimate/Indicators.hpp"
#include "contact/problem/Summary.hpp"
#include "contact/solve/Report.hpp"

#include <string>

namespace epafi::drivers {

/// What a mesh and the spaces on it are.
struct Size {
  int elements = 0;
  bem::Index displacements = 0;  ///< unknown ones: without the prescribed
  bem::Index multipliers = 0;
  bem::Index densities = 0;
  int degreeMin = 0;
  int degreeMax = 0;
  double sizeMin = 0;  ///< [length]
  double sizeMax = 0;

  bem::Index dof() const { return displacements + multipliers; }
};

Size sizeOf(const bem::Space& space, const contact::MultiplierSpace& multiplier,
            const contact::Conditions& conditions);

/// CPU seconds of one level, all threads.
struct Seconds {
  double assembly = 0;       ///< V, K, W
  double factorization = 0;  ///< V = L Lᵀ, S
  double stabilization = 0;  ///< traction rows, A and its factor, the condensed problem
  double newton = 0;
  double estimate = 0;  ///< indicators
};

/// A row of history.csv.
struct LevelRow {
  int level = 0;
  Size size;
  contact::Summary summary;
  contact::Report report;
  double gamma0 = 0;                    ///< zero without stabilisation
  double estimate = 0;                  ///< [(stress length²)^½] under Weights "Energy"
  adaptivity::Contributions squares{};  ///< of which it is made
  Seconds seconds;
  double secondsTotal = 0;  ///< CPU since the program's start
  double secondsWall = 0;   ///< likewise by the clock on the wall
  double memory = 0;        ///< peak so far [MiB]
};

/// The columns of history.csv, and a row in their order.                 [design.md 1.4]
std::vector<std::string> historyColumns();
std::vector<std::string> historyCells(const LevelRow& row);

/// history.csv: its head, one line per level, or all of it.
std::string historyHead();
std::string historyLine(const LevelRow& row);
std::string historyCsv(const std::vector<LevelRow>& rows);

}  // namespace epafi::drivers
