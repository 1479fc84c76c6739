#include "drivers/commands/Recorder.hpp"

#include "bem/base/Error.hpp"
#include "drivers/output/BoundaryLines.hpp"
#include "drivers/output/Inside.hpp"
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
    added_.assign(rowsOf(tables_.history).size(), more_(nullptr, {}));
    folder_->write("history.csv", history());
  }
  folder_->write("used.xml", tables_.used);
  folder_->drop("interior.csv");  // of an earlier level
}

void Recorder::beginWith(const std::string& folder) {
  if (!folder_)
    return;
  restored_ = folder + "/";
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
    if (std::filesystem::exists(restored_ + name))
      files_.emplace_back(name, [file = restored_ + name] { return readText(file); });
}

void Recorder::take(const SolvedLevel& level) {
  if (!folder_)
    return;
  const LevelRow row = rowOf(level);
  const double begin = cpuSeconds();
  const bool onPath = level.level.onPath();
  tables_.addLevel(level, row);
  added_.push_back(more_(&level, row));
  files_ = {{"history.csv", made(history())}};
  std::move(stepFiles_.begin(), stepFiles_.end(), std::back_inserter(files_));
  stepFiles_.clear();
  if (scene_.output.fields) {
    grid_ = std::make_shared<const VtkGrid>(boundaryLines(level.last()));
    if (onPath)
      files_.emplace_back("steps.pvd", made(stepsPvd(times_, "boundary.vtu")));
  }
  if (scene_.hasContact())
    files_.emplace_back("contact.csv", made(onPath ? std::exchange(contactOfStep_, {})
                                                   : contact_.next(level.last())));
  if (scene_.output.fields)
    files_.emplace_back("boundary.csv",
                        [this, grid = grid_] { return boundaryCsv(scene_, *grid); });
  if (scene_.tellsBodies())
    files_.emplace_back("bodies.csv", made(tables_.bodies));
  times_.clear();
  contact_ = {};
  stages_ += bem::message("level ", row.level, ": ", contact::told(row.report.stages),
                          "\n", contact::meritsTold(row.report.stages));
  pressure_ = pressureLine(level);
  warnings_ = warningsOf(level);
  if (row.operators == denseInstead)
    told_.push_back(bem::message("level ", row.level, ": ", row.note));
  warnings_.insert(warnings_.begin(), told_.begin(), told_.end());
  tables_.take(level, row);
  isTaken_ = true;
  writeIfDue();  // who reads the line may look for its row in the file
  progress_.clear();
  table_ << tableLine(row) << notesOn(row, scene_.stabilization.firstGamma0())
         << std::flush;
  apart_ += cpuSeconds() - begin;
}

void Recorder::takeStep(const SolvedLevel& level) {
  if (!folder_)
    return;
  const LevelRow row = rowOf(level);
  const double begin = cpuSeconds();
  const SolvedStep& step = level.last();
  tables_.addStep(step);
  if (times_.empty())
    overlaps_.clear();  // those of the level before
  times_.push_back(step.row.t);
  if (scene_.hasContact()) {
    contactOfStep_ = contact_.next(step);
    stepFiles_.emplace_back(stepFile(times_.size(), "contact.csv"), made(contactOfStep_));
  }
  std::shared_ptr<const VtkGrid> grid;
  if (scene_.output.fields) {
    grid = std::make_shared<const VtkGrid>(boundaryLines(step));
    stepFiles_.emplace_back(stepFile(times_.size(), "boundary.vtu"),
                            made(vtuText(*grid)));
    if (overlaps_.empty())
      findOverlap(scene_, *grid, overlaps_);
  }
  if (!isKnown(level.level)) {
    grid_ = grid;
    tables_.take(level, row);
    isTaken_ = true;
    writeIfDue();
    progress_.clear();
    table_ << tableLine(step.row) << std::flush;
  }
  apart_ += cpuSeconds() - begin;
}

void Recorder::writeIfDue() {
  if (cpuSeconds() - writtenAt_ > std::max(longestWait, workPerWriting * writingTook_))
    write();
}

void Recorder::write() {
  if (!isTaken_ && restored_.empty())
    return;
  const double begin = cpuSeconds();
  for (const auto& [name, text] : files_)
    folder_->stage(name, text());
  if (!tables_.steps.empty())
    folder_->stage("steps.csv", tables_.steps);
  if (scene_.output.fields)
    folder_->stage("solution.hdf", isTaken_ ? solutionFile(scene_, tables_, *grid_)
                                            : readText(restored_ + "solution.hdf"));
  folder_->dropMade();
  folder_->commit();
  if (isTaken_ && tables_.level.onPath() && tables_.level.complete)
    folder_->dropStepsBehind(tables_.level.steps.size());
  if (isTaken_)
    written_(tables_.level);
  files_.clear();
  restored_.clear();
  isTaken_ = false;
  writtenAt_ = cpuSeconds();
  writingTook_ = writtenAt_ - begin;
}

void Recorder::finish(PhaseTimer& timer) {
  if (folder_) {
    write();  // before a phase begins, which an interrupted run does not do any more
    if (grid_ && !scene_.history)
      findOverlap(scene_, *grid_, overlaps_);
    warnings_.insert(warnings_.end(), overlaps_.begin(), overlaps_.end());
    if (!tables_.level.steps.empty() && !scene_.output.interiorPoints.empty())
      timer.run(Phase::Results, [&] { writeInterior(scene_, tables_.level, *folder_); });
  }
  writeTimings(timer);
}

void Recorder::writeTimings(PhaseTimer& timer) {
  if (folder_)
    folder_->write("timings.txt", timer.report() + stages_);
}

std::string Recorder::history() const {
  std::vector<CsvRow> rows = rowsOf(tables_.history);
  if (added_.empty() || added_.front().empty())
    return tables_.history;
  std::string text;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    append(rows[k], added_[k]);
    addRow(rows[k], text);
  }
  return text;
}

LevelRow Recorder::rowOf(const SolvedLevel& level) const {
  LevelRow row = level.row;
  row.secondsTotal -= apart_;
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
