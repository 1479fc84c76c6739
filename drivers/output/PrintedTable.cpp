#include "drivers/output/PrintedTable.hpp"

#include "drivers/process/Resources.hpp"
#include "drivers/scene/Text.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace epafi::drivers {

namespace {

/// With two digits behind the point.
std::string fixed(double value) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << value;
  return text.str();
}

/// A part of the energy norm, with three digits.
std::string percent(double part) {
  std::ostringstream text;
  text << std::setprecision(3) << 100 * part;
  return text.str();
}

/// Calls add(name, width, value, digits) for each column of the table that a run prints.
template <class Add>
void forEachColumn(const LevelRow& r, const Add& add) {
  const bool isUniform = r.degreeMin == r.degreeMax;
  const bool isCoulomb = r.report.coulombIterations != 0;
  const auto two = [](int a, const char* between, int b, bool both) {
    return both ? bem::message(a, between, b) : bem::message(a);
  };
  add("level", 5, r.level, 0);
  add("elements", 9, r.elements, 0);
  add("dof", 7, r.dof(), 0);
  add("degree", 7, two(r.degreeMin, "-", r.degreeMax, !isUniform), 0);
  add("steps", 9,
      two(r.report.newtonIterations, "/", r.report.coulombIterations, isCoulomb), 0);
  add("estimate", 11, r.estimate, 4);
  add("error %", 9, percent(r.relativeEstimate), 0);
  add("strain energy", 16, r.summary.energyStrain, 9);
  add("load energy", 16, r.summary.energyLoad, 9);
  add("friction", 13, r.energyFriction, 6);
  add("normal force", 15, r.summary.forceNormal, 8);
  add("CPU s", 9, fixed(r.secondsTotal), 0);
  add("wall s", 9, fixed(r.secondsWall), 0);
}

constexpr std::size_t contactsShown = 3;

/// Those with the largest forces, if there are more than are shown.
template <class Contacts>
Contacts largest(Contacts contacts) {
  if (contacts.size() <= contactsShown)
    return contacts;
  const auto force = [](const auto& contact) {
    return std::hypot(contact.second.forceNormal, contact.second.forceTangential);
  };
  std::stable_sort(contacts.begin(), contacts.end(),
                   [&](const auto& a, const auto& b) { return force(a) > force(b); });
  contacts.resize(contactsShown);
  return contacts;
}

}  // namespace

std::string tableHead() {
  std::ostringstream line;
  forEachColumn({}, [&](const char* name, int width, const auto&, int) {
    line << ' ' << std::setw(width - 1) << name;
  });
  line << '\n';
  return line.str();
}

std::string tableLine(const LevelRow& row) {
  std::ostringstream line;
  forEachColumn(row, [&](const char*, int width, const auto& value, int digits) {
    line << ' ' << std::setw(width - 1) << std::setprecision(digits) << value;
  });
  line << (row.report.converged() ? "\n" : "  not converged\n");
  return line.str();
}

std::string tableLine(const StepRow& row) {
  std::ostringstream line;
  line << "        step " << std::setw(4) << row.step << "  t = " << std::left
       << std::setw(10) << row.t << std::right << std::setw(16)
       << counted(row.newtonIterations, "Newton step", "Newton steps")
       << ", friction's work " << row.energyDissipated << std::setprecision(5);
  for (const auto& [name, contact] : largest(row.contacts))
    line << (name.empty() ? ";" : "; " + name) << " normal force " << contact.forceNormal
         << ", shear " << contact.forceTangential;
  if (row.contacts.size() > contactsShown)
    line << "; " << row.contacts.size() - contactsShown << " more in steps.csv";
  for (const auto& [name, summary] : row.rigid)
    line << "; " << name << " at (" << summary.motion.slide.x << ", "
         << summary.motion.slide.y << "), turned by " << summary.motion.turn;
  if (row.parts > 1)
    line << "; halved: " << row.parts << " parts";
  line << (row.converged ? "\n" : "  not converged\n");
  return line.str();
}

std::string notesOn(const LevelRow& row, double gamma0) {
  std::ostringstream text;
  text << std::setprecision(4);
  const std::string level = bem::message("level ", row.level);
  if (row.gamma0 != 0 && row.gamma0 != gamma0)
    text << "        Gamma0 = " << row.gamma0 << " on " << level << ": the default, "
         << gamma0 << ", would make its stiffness indefinite\n";
  if (!row.note.empty())
    text << "        " << level << ": " << row.note << '\n';
  if (row.worstStep != 0)
    text << "        " << level << ": the largest error is that of step " << row.worstStep
         << ", estimated " << row.worstEstimate << '\n';
  return text.str();
}

std::string pressureLine(const SolvedLevel& level) {
  contact::PeakPressure peak = level.row.summary.peak;
  for (const auto& step : level.steps)
    for (const auto& [name, summary] : step->row.contacts)
      peak.add(summary.peak);
  if (peak.value() == 0)
    return "";
  std::ostringstream text;
  text << std::setprecision(4) << "pressure up to " << peak.value()
       << " where elements resolve it, with an error of " << peak.error()
       << (peak.isUnbounded() ? "; unbounded at an end of a side" : "") << '\n';
  return text.str();
}

std::string timeSummary(const PhaseTimer& timer) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << "time    " << cpuSeconds()
       << " s of CPU, " << timer.wallSeconds() << " s:";
  for (int i = 0; i < phaseCount; ++i) {
    const auto phase = static_cast<Phase>(i);
    text << (i == 0 ? " " : ", ") << nameOf(phase) << ' ' << timer.totalSeconds(phase);
  }
  text << "\nmemory  " << std::setprecision(0) << peakMemory() << " MiB at most\n";
  return text.str();
}

}  // namespace epafi::drivers
