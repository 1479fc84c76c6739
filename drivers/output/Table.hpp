#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace epafi::drivers {

/// A number with 17 significant digits, enough to read back the same double.
std::string exactly(double value);

/// What a cell holds: a number, a whole number or a word; an empty word is a value that is not known.
using Value = std::variant<double, long long, std::string>;

/// A cell of a row with what there is to say of its column, in Markdown.  Where nothing is said
/// of a column it shares meaning and unit with the column before it.
struct Cell {
  std::string name;
  Value value;
  const char* meaning = "";
  const char* unit = "";
};

/// A row of a table.  All rows of a table have the same columns, of the same kinds.
using Cells = std::vector<Cell>;

void append(Cells& row, const Cells& more, const std::string& prefix = "");
/// Adds a row to comma-separated values (RFC 4180), behind a line of names where there are none.
void addRow(const Cells& row, std::string& csv);
/// The cells of the first line of comma-separated values, which is taken off the text.
std::vector<std::string> csvCells(std::string_view& text);

/// Rows that are read again, by a restart or beside a reference.
class Table {
 public:
  /// Without rows, with the columns of this one.
  explicit Table(const Cells& like = {});

  void add(const Cells& row);
  /// Leaves the first rows.
  void keep(std::size_t rows);

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_.size(); }
  bool hasColumns() const { return !columns_.empty(); }
  bool hasColumnsOf(const Table& other) const;
  /// \throws bem::InputError without such a column, or where a value is of another kind
  double number(std::size_t row, const std::string& column) const;
  const std::string& word(std::size_t row, const std::string& column) const;
  /// The rows of which a column of whole numbers holds this one.
  std::vector<std::size_t> rowsWith(const std::string& column, long long value) const;

  /// Comma-separated values; `beside`: further columns, of as many rows, or none.
  std::string csv(const Table& beside = Table()) const;

  /// As numbers, row by row, and a text of four lines of comma-separated values: the names of the
  /// columns, their kinds ("number", "whole", "word"), their units and the words, by whose places
  /// in this line numbers stand for them.
  std::pair<std::string, std::vector<double>> packed() const;
  /// The inverse; `numbers` are asked for by the number of columns.
  /// \throws bem::InputError for a text that is none of packed(), and for words that it lacks
  static Table unpacked(const std::string& columns,
                        const std::function<std::vector<double>(std::size_t)>& numbers);

 private:
  struct Column {
    std::string name;
    std::string unit;
    std::size_t kind;  ///< of its values: which of Value's
  };

  const Value& at(std::size_t row, const std::string& column) const;

  std::vector<Column> columns_;
  std::vector<Value> values_;  ///< row by row
  std::size_t rows_ = 0;
};

}  // namespace epafi::drivers
