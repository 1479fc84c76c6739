#include "drivers/output/Table.hpp"

#include "bem/base/Error.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace epafi::drivers {

namespace {

/// In the order of Value.
constexpr std::array<const char*, 3> kinds{"number", "whole", "word"};

/// Appends a word, quoted where RFC 4180 requires it: users choose names freely.
void addWord(const std::string& word, std::string& line) {
  if (word.find_first_of(",\"\r\n") == std::string::npos) {
    line += word;
    return;
  }
  line += '"';
  for (const char c : word)
    line.append(c == '"' ? 2 : 1, c);
  line += '"';
}

void addValue(const Value& value, std::string& line) {
  if (const double* number = std::get_if<double>(&value))
    line += exactly(*number);
  else if (const auto* whole = std::get_if<long long>(&value))
    line += std::to_string(*whole);
  else
    addWord(std::get<std::string>(value), line);
}

/// A line of what `add(one, line)` adds for each.
template <class Range, class Add>
void addLine(const Range& all, const Add& add, std::string& text) {
  bool isFirst = true;
  for (const auto& one : all) {
    if (!std::exchange(isFirst, false))
      text += ',';
    add(one, text);
  }
  text += '\n';
}

constexpr const char* damaged = "has a table that is damaged";

}  // namespace

std::string exactly(double value) {
  char text[32];  // as %.17g of printf, but much faster
  const auto end =
      std::to_chars(text, text + sizeof text, value, std::chars_format::general, 17);
  return {text, end.ptr};
}

void append(Cells& row, const Cells& more, const std::string& prefix) {
  for (const Cell& cell : more)
    row.push_back({prefix + cell.name, cell.value, cell.meaning, cell.unit});
}

void addRow(const Cells& row, std::string& csv) {
  if (csv.empty())
    addLine(
        row, [](const Cell& cell, std::string& line) { addWord(cell.name, line); }, csv);
  addLine(
      row, [](const Cell& cell, std::string& line) { addValue(cell.value, line); }, csv);
}

std::vector<std::string> csvCells(std::string_view& text) {
  std::vector<std::string> cells(1);
  bool inQuotes = false;
  std::size_t i = 0;
  for (; i < text.size() && (inQuotes || text[i] != '\n'); ++i) {
    if (text[i] == ',' && !inQuotes)
      cells.emplace_back();
    else if (text[i] != '"')
      cells.back() += text[i];
    else if (inQuotes && text.compare(i, 2, "\"\"") == 0)
      cells.back() += text[i++];
    else
      inQuotes = !inQuotes;
  }
  text.remove_prefix(std::min(i + 1, text.size()));
  return cells;
}

Table::Table(const Cells& like) {
  for (const Cell& cell : like) {
    const bool shares = *cell.meaning == '\0' && *cell.unit == '\0' && !columns_.empty();
    columns_.push_back(
        {cell.name, shares ? columns_.back().unit : cell.unit, cell.value.index()});
  }
}

void Table::add(const Cells& row) {
  if (rows_++ == 0 && columns_.empty())
    columns_ = std::move(Table(row).columns_);
  for (const Cell& cell : row)
    values_.push_back(cell.value);
}

void Table::keep(std::size_t rows) {
  rows_ = std::min(rows, rows_);
  values_.resize(rows_ * columns_.size());
}

bool Table::hasColumnsOf(const Table& other) const {
  return std::equal(columns_.begin(), columns_.end(), other.columns_.begin(),
                    other.columns_.end(), [](const Column& a, const Column& b) {
                      return a.name == b.name && a.kind == b.kind;
                    });
}

const Value& Table::at(std::size_t row, const std::string& column) const {
  const auto found = std::find_if(columns_.begin(), columns_.end(),
                                  [&](const Column& one) { return one.name == column; });
  if (found == columns_.end() || row >= rows_)
    throw bem::InputError("has a table without ", column);
  return values_[row * columns_.size() +
                 static_cast<std::size_t>(found - columns_.begin())];
}

double Table::number(std::size_t row, const std::string& column) const {
  const Value& value = at(row, column);
  if (const double* number = std::get_if<double>(&value))
    return *number;
  if (const auto* whole = std::get_if<long long>(&value))
    return static_cast<double>(*whole);
  throw bem::InputError(damaged);
}

const std::string& Table::word(std::size_t row, const std::string& column) const {
  const auto* word = std::get_if<std::string>(&at(row, column));
  return word != nullptr ? *word : throw bem::InputError(damaged);
}

std::vector<std::size_t> Table::rowsWith(const std::string& column,
                                         long long value) const {
  std::vector<std::size_t> found;
  for (std::size_t row = 0; row < rows_; ++row)
    if (at(row, column) == Value(value))
      found.push_back(row);
  return found;
}

std::string Table::csv(const Table& beside) const {
  std::string text;
  const auto addLines = [&](const auto& of, const auto& add) {
    addLine(of(*this), add, text);
    if (!beside.columns_.empty()) {
      text.back() = ',';
      addLine(of(beside), add, text);
    }
  };
  if (!columns_.empty())
    addLines([](const Table& table) { return table.columns_; },
             [](const Column& column, std::string& line) { addWord(column.name, line); });
  for (std::size_t row = 0; row < rows_; ++row)
    addLines(
        [&](const Table& table) {
          const auto begin = table.values_.begin() +
                             static_cast<std::ptrdiff_t>(row * table.columns_.size());
          return std::vector<Value>(
              begin, begin + static_cast<std::ptrdiff_t>(table.columns_.size()));
        },
        addValue);
  return text;
}

std::pair<std::string, std::vector<double>> Table::packed() const {
  std::vector<std::string> words;
  std::vector<double> numbers;
  for (const Value& value : values_) {
    const auto* word = std::get_if<std::string>(&value);
    if (word == nullptr) {
      numbers.push_back(std::holds_alternative<double>(value)
                            ? std::get<double>(value)
                            : static_cast<double>(std::get<long long>(value)));
      continue;
    }
    const auto known = std::find(words.begin(), words.end(), *word);
    numbers.push_back(static_cast<double>(known - words.begin()));
    if (known == words.end())
      words.push_back(*word);
  }
  std::string text;
  const auto addNames = [&](auto nameOf) {
    addLine(
        columns_,
        [&](const Column& column, std::string& line) { addWord(nameOf(column), line); },
        text);
  };
  if (columns_.empty())
    return {};
  addNames([](const Column& column) { return column.name; });
  addNames([](const Column& column) { return std::string(kinds[column.kind]); });
  addNames([](const Column& column) { return column.unit; });
  addLine(words, addWord, text);
  return {std::move(text), std::move(numbers)};
}

Table Table::unpacked(const std::string& columns,
                      const std::function<std::vector<double>(std::size_t)>& numbers) {
  std::string_view text = columns;
  std::array<std::vector<std::string>, 4> lines;
  for (std::vector<std::string>& cells : lines)
    if (!text.empty())
      cells = csvCells(text);
  const auto& [names, ofKind, units, words] = lines;
  Table table;
  if (ofKind.size() != names.size() || units.size() != names.size())
    throw bem::InputError(damaged);
  for (std::size_t k = 0; k < names.size(); ++k) {
    const auto kind = std::find(kinds.begin(), kinds.end(), ofKind[k]);
    if (kind == kinds.end())
      throw bem::InputError(damaged);
    table.columns_.push_back(
        {names[k], units[k], static_cast<std::size_t>(kind - kinds.begin())});
  }
  std::size_t place = 0;
  for (const double number : numbers(std::max<std::size_t>(names.size(), 1))) {
    const std::size_t kind = names.empty() ? throw bem::InputError(damaged)
                                           : table.columns_[place++ % names.size()].kind;
    const bool isWhole = std::abs(number) < 1e15 && number == std::floor(number);
    if (kind == 0)
      table.values_.emplace_back(number);
    else if (kind == 1 && isWhole)
      table.values_.emplace_back(static_cast<long long>(number));
    else if (kind == 2 && isWhole && number >= 0 &&
             number < static_cast<double>(words.size()))
      table.values_.emplace_back(words[static_cast<std::size_t>(number)]);
    else
      throw bem::InputError(damaged);
  }
  table.rows_ = names.empty() ? 0 : place / names.size();
  return table;
}

}  // namespace epafi::drivers
