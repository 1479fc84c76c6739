#include "drivers/output/PrintedTable.hpp"

#include "drivers/scene/Text.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace epafi::drivers {

namespace {

std::string fixed(double value, int digits) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

std::string degrees(const LevelRow& row) {
  const std::string low = std::to_string(row.degreeMin);
  return row.degreeMin == row.degreeMax ? low : low + "-" + std::to_string(row.degreeMax);
}

std::string iterations(const contact::Report& report) {
  const std::string newton = std::to_string(report.newtonIterations);
  return report.coulombIterations == 0
             ? newton
             : newton + "/" + std::to_string(report.coulombIterations);
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

struct Column {
  const char* name;
  int width;
  std::string (*cell)(const LevelRow& row);
};

constexpr Column columns[] = {
    {"level", 5, [](const LevelRow& r) { return std::to_string(r.level); }},
    {"elements", 9, [](const LevelRow& r) { return std::to_string(r.elements); }},
    {"dof", 7, [](const LevelRow& r) { return std::to_string(r.dof()); }},
    {"degree", 7, [](const LevelRow& r) { return degrees(r); }},
    {"steps", 9, [](const LevelRow& r) { return iterations(r.report); }},
    {"estimate", 11, [](const LevelRow& r) { return significant(r.estimate, 4); }},
    {"strain energy", 16,
     [](const LevelRow& r) { return significant(r.summary.energyStrain, 9); }},
    {"load energy", 16,
     [](const LevelRow& r) { return significant(r.summary.energyLoad, 9); }},
    {"friction", 13, [](const LevelRow& r) { return significant(r.energyFriction, 6); }},
    {"normal force", 15,
     [](const LevelRow& r) { return significant(r.summary.forceNormal, 8); }},
    {"CPU s", 9, [](const LevelRow& r) { return fixed(r.secondsTotal, 2); }},
    {"wall s", 9, [](const LevelRow& r) { return fixed(r.secondsWall, 2); }},
};

}  // namespace

std::string significant(double value, int digits) {
  std::ostringstream text;
  text << std::setprecision(digits) << value;
  return text.str();
}

std::string tableHead() {
  std::ostringstream line;
  for (const Column& column : columns)
    line << ' ' << std::setw(column.width - 1) << column.name;
  line << '\n';
  return line.str();
}

std::string tableLine(const LevelRow& row) {
  std::ostringstream line;
  for (const Column& column : columns)
    line << ' ' << std::setw(column.width - 1) << column.cell(row);
  if (row.report.status != contact::Status::Converged)
    line << "  not converged";
  line << '\n';
  return line.str();
}

std::string tableLine(const StepRow& row) {
  std::ostringstream line;
  line << "        step " << std::setw(4) << row.step << "  t = " << std::left
       << std::setw(10) << significant(row.t, 6) << std::right << std::setw(16)
       << counted(row.newtonIterations, "Newton step", "Newton steps")
       << ", friction's work " << significant(row.energyDissipated, 6);
  for (const auto& [name, contact] : largest(row.contacts))
    line << (name.empty() ? ";" : "; " + name) << " normal force "
         << significant(contact.forceNormal, 5) << ", shear "
         << significant(contact.forceTangential, 5);
  if (row.contacts.size() > contactsShown)
    line << "; " << row.contacts.size() - contactsShown << " more in steps.csv";
  for (const auto& [name, summary] : row.rigid)
    line << "; " << name << " at (" << significant(summary.motion.slide.x, 5) << ", "
         << significant(summary.motion.slide.y, 5) << "), turned by "
         << significant(summary.motion.turn, 5);
  if (row.parts > 1)
    line << "; halved: " << row.parts << " parts";
  line << (row.converged ? "\n" : "  not converged\n");
  return line.str();
}

std::string gamma0Note(const LevelRow& row, double wanted) {
  if (row.gamma0 == 0 || row.gamma0 == wanted)
    return "";
  return "        Gamma0 = " + significant(row.gamma0, 4) + " on level " +
         std::to_string(row.level) + ": the default, " + significant(wanted, 4) +
         ", would make its stiffness indefinite\n";
}

std::string operatorsNote(const LevelRow& row) {
  return row.note.empty()
             ? ""
             : "        level " + std::to_string(row.level) + ": " + row.note + "\n";
}

std::string worstStepNote(const LevelRow& row) {
  return row.worstStep == 0 ? ""
                            : "        level " + std::to_string(row.level) +
                                  ": the largest error is that of step " +
                                  std::to_string(row.worstStep) + ", estimated " +
                                  significant(row.worstEstimate, 4) + "\n";
}

std::string timeSummary(const PhaseTimer& timer) {
  std::ostringstream text;
  text << "time    " << fixed(cpuSeconds(), 2) << " s of CPU, "
       << fixed(timer.wallSeconds(), 2) << " s:";
  for (int i = 0; i < phaseCount; ++i) {
    const auto phase = static_cast<Phase>(i);
    text << (i == 0 ? " " : ", ") << nameOf(phase) << ' '
         << fixed(timer.totalSeconds(phase), 2);
  }
  text << "\nmemory  " << fixed(peakMemory(), 0) << " MiB at most\n";
  return text.str();
}

}  // namespace epafi::drivers
