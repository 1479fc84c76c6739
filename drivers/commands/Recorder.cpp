#include "drivers/commands/Recorder.hpp"

#include "bem/base/Error.hpp"
#include "drivers/output/BoundaryLines.hpp"
#include "drivers/output/Inside.hpp"
#include "drivers/output/PrintedTable.hpp"
#include "drivers/run/Warnings.hpp"
#include "drivers/scene/SceneFile.hpp"

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <utility>

namespace epafi::drivers {

namespace {

/// How much work may wait for its files [CPU seconds]: so much of a run is lost at most if it
/// is killed, and files of small levels and of steps cost as much as solving them.
constexpr double longestWait = 0.5;
/// Or so many times as much work as the files took last: those of a path grow with its steps.
constexpr double workPerWriting = 10;

/// On the level that ends a run only: many points cost more than the levels.
void writeInterior(const Scene& scene, const Level& level, OutputFolder& folder) {
  const BodyInsides insides(scene, level, level.last());
  std::vector<InsidePoint> points;
  for (const bem::Vec2 x : scene.output.interiorPoints)
    points.push_back({scene.bodyAt(scene.drawn(x)), x});
  std::string csv;
  insides.addTo(csv, points, insides.at(points));
  folder.write("interior.csv", csv);
}

std::function<std::string()> made(std::string text) {
  return [text = std::move(text)] { return text; };
}

}  // namespace

Recorder::Recorder(const Scene& scene, const std::optional<Checkpoint>& earlier,
                   std::optional<OutputFolder>& folder, const ProgressLine& progress,
                   std::ostream& table, std::function<void(const Level&)> written,
                   MoreColumns more)
    : scene_(scene),
      earlier_(earlier),
      folder_(folder),
      progress_(progress),
      table_(table),
      written_(std::move(written)),
      more_(std::move(more)),
      tables_(Checkpoint::before(scene, earlier)) {
  if (!folder_)
    return;
  if (earlier_) {  // without rows of levels that did not make it
    for (std::size_t k = 0; k < tables_.history.rows(); ++k)
      added_.add(more_(nullptr, {}));
    folder_->write("history.csv", tables_.history.csv(added_));
  }
  folder_->write("used.xml", tables_.used);
  folder_->drop("interior.csv");  // of an earlier level
}

void Recorder::beginWith(const std::string& folder) {
  if (!folder_)
    return;
  waiting_.restored = folder + "/";
  std::vector<std::string> names{"contact.csv", "bodies.csv"};
  std::vector<std::string> ofSteps{"contact.csv"};
  if (scene_.output.fields) {
    names.insert(names.end(), {"boundary.csv", "steps.pvd"});
    ofSteps.emplace_back("boundary.vtu");
  }
  for (std::size_t k = 1; k <= scene_.history.times.size(); ++k)
    for (const std::string& name : ofSteps)
      names.push_back(stepFile(k, name));
  for (const std::string& name : names)
    if (std::filesystem::exists(waiting_.restored + name))
      waiting_.files.emplace_back(
          name, [file = waiting_.restored + name] { return readText(file); });
}

void Recorder::take(const SolvedLevel& level) {
  if (!folder_)
    return;
  const LevelRow row = rowOf(level);
  const double begin = cpuSeconds();
  const bool onPath = level.level.onPath();
  tables_.addLevel(level, row);
  added_.add(more_(&level, row));
  waiting_.files = {{"history.csv", made(tables_.history.csv(added_))}};
  std::move(way_.files.begin(), way_.files.end(), std::back_inserter(waiting_.files));
  if (scene_.output.fields) {
    grid_ = std::make_shared<const VtkGrid>(boundaryLines(level.last()));
    if (onPath)
      waiting_.files.emplace_back("steps.pvd",
                                  made(stepsPvd(way_.times, "boundary.vtu")));
  }
  if (scene_.hasContact())
    waiting_.files.emplace_back("contact.csv",
                                made(onPath ? std::exchange(way_.contact, {})
                                            : way_.contacts.next(level.last())));
  if (scene_.output.fields)
    waiting_.files.emplace_back(
        "boundary.csv", [this, grid = grid_] { return boundaryCsv(scene_, *grid); });
  if (scene_.tellsBodies())
    waiting_.files.emplace_back("bodies.csv", made(tables_.bodies.csv()));
  way_ = {};
  told_.stages +=
      bem::message("level ", row.level, ": ", contact::told(row.report.stages), "\n",
                   contact::meritsTold(row.report.stages));
  told_.pressure = pressureLine(level);
  told_.warnings = warningsOf(level);
  if (row.operators == denseInstead)
    told_.fallbacks.push_back(bem::message("level ", row.level, ": ", row.note));
  told_.warnings.insert(told_.warnings.begin(), told_.fallbacks.begin(),
                        told_.fallbacks.end());
  tables_.take(level, row);
  waiting_.isTaken = true;
  writeIfDue();  // who reads the line may look for its row in the file
  progress_.clear();
  table_ << tableLine(row) << notesOn(row, scene_.stabilization.firstGamma0())
         << std::flush;
  pace_.apart += cpuSeconds() - begin;
}

void Recorder::takeStep(const SolvedLevel& level) {
  if (!folder_)
    return;
  const LevelRow row = rowOf(level);
  const double begin = cpuSeconds();
  const SolvedStep& step = level.last();
  tables_.addStep(step);
  if (way_.times.empty())
    told_.overlaps.clear();  // those of the level before
  way_.times.push_back(step.row.t);
  if (scene_.hasContact()) {
    way_.contact = way_.contacts.next(step);
    way_.files.emplace_back(stepFile(way_.times.size(), "contact.csv"),
                            made(way_.contact));
  }
  std::shared_ptr<const VtkGrid> grid;
  if (scene_.output.fields) {
    grid = std::make_shared<const VtkGrid>(boundaryLines(step));
    way_.files.emplace_back(stepFile(way_.times.size(), "boundary.vtu"),
                            made(vtuText(*grid)));
    if (told_.overlaps.empty())
      findOverlap(scene_, *grid, told_.overlaps);
  }
  if (!isKnown(level.level)) {
    grid_ = grid;
    tables_.take(level, row);
    waiting_.isTaken = true;
    writeIfDue();
    progress_.clear();
    table_ << tableLine(step.row) << std::flush;
  }
  pace_.apart += cpuSeconds() - begin;
}

void Recorder::writeIfDue() {
  if (cpuSeconds() - pace_.writtenAt >
      std::max(longestWait, workPerWriting * pace_.writingTook))
    write();
}

void Recorder::write() {
  if (!waiting_.isTaken && waiting_.restored.empty())
    return;
  const double begin = cpuSeconds();
  for (const auto& [name, text] : waiting_.files)
    folder_->stage(name, text());
  if (tables_.steps.rows() > 0)
    folder_->stage("steps.csv", tables_.steps.csv());
  if (scene_.output.fields)
    folder_->stage("solution.hdf", waiting_.isTaken
                                       ? solutionFile(scene_, tables_, *grid_)
                                       : readText(waiting_.restored + "solution.hdf"));
  folder_->dropMade();
  folder_->commit();
  if (waiting_.isTaken && tables_.level.onPath() && tables_.level.complete)
    folder_->dropStepsBehind(tables_.level.steps.size());
  if (waiting_.isTaken)
    written_(tables_.level);
  waiting_ = {};
  pace_.writtenAt = cpuSeconds();
  pace_.writingTook = pace_.writtenAt - begin;
}

void Recorder::finish(PhaseTimer& timer) {
  if (folder_) {
    write();  // before a phase begins, which an interrupted run does not do any more
    if (grid_ && !scene_.history)
      findOverlap(scene_, *grid_, told_.overlaps);
    told_.warnings.insert(told_.warnings.end(), told_.overlaps.begin(),
                          told_.overlaps.end());
    if (!tables_.level.steps.empty() && !scene_.output.interiorPoints.empty())
      timer.run(Phase::Results, [&] { writeInterior(scene_, tables_.level, *folder_); });
  }
  writeTimings(timer);
}

void Recorder::writeTimings(PhaseTimer& timer) {
  if (folder_)
    folder_->write("timings.txt", timer.report() + told_.stages);
}

LevelRow Recorder::rowOf(const SolvedLevel& level) const {
  LevelRow row = level.row;
  row.secondsTotal -= pace_.apart;
  if (earlier_) {
    row.secondsTotal += earlier_->secondsTotal;
    row.secondsWall += earlier_->secondsWall;
  }
  return row;
}

bool Recorder::isKnown(const Level& level) const {
  return earlier_ && level.number == earlier_->level.number &&
         level.path.size() < earlier_->level.path.size();
}

}  // namespace epafi::drivers
