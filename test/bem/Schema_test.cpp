#include "bem/base/Schema.hpp"

#include "bem/base/Error.hpp"
#include "bem/base/Suggestion.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>
#include <Teuchos_UnitTestHarness.hpp>

namespace epafi {

namespace {

using Teuchos::ParameterList;

const bem::SchemaRows& rows() {
  using bem::Kind;
  using bem::Row;
  static const bem::SchemaRows table = {
      Row("Tolerance", Kind::Real, "accuracy").standard(1e-6).range({0, 1, true, true}),
      Row("Steps", Kind::Whole, "how many").standard(10).range(bem::from(1)),
      Row("Values", Kind::Names, "texts").standard("{}"),
      Row("Inner", Kind::List, "of its own"),
      Row("Inner->Law", Kind::Text, "law").standard("None").allowed({"None", "Tresca"}),
  };
  return table;
}

std::string complaint(const ParameterList& list) {
  try {
    bem::complete(rows(), list, "list");
  } catch (const bem::InputError& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

template <class T>
ParameterList with(const std::string& name, const T& value) {
  ParameterList list;
  list.set(name, value);
  return list;
}

}  // namespace

TEUCHOS_UNIT_TEST(Schema, editDistanceCountsTheFewestChanges) {
  TEST_EQUALITY(bem::editDistance("Degree", "Degree"), 0);
  TEST_EQUALITY(bem::editDistance("Degre", "Degree"), 1);
  TEST_EQUALITY(bem::editDistance("kitten", "sitting"), 3);
  TEST_EQUALITY(bem::editDistance("abc", ""), 3);
  TEST_EQUALITY(bem::editDistance("", "abc"), 3);
  TEST_EQUALITY(bem::nearest("Gama0", {"Beta", "Gamma0", "Eta"}), "Gamma0");
  // Candidates that are too long to be the nearest do not hide those that are not.
  TEST_EQUALITY(bem::nearest("Gam", {"Gamma0 of the stabilisation", "Beta", "Gamma0"}),
                "Gamma0");
  TEST_EQUALITY(bem::nearest("Tolerance of the solver", {"x", "Tolerance", "Solver"}),
                "Tolerance");
  TEST_EQUALITY(bem::nearest("x", {}), "");
}

TEUCHOS_UNIT_TEST(Schema, validationFillsInDefaultsOnAllLevels) {
  const ParameterList list = bem::complete(rows(), {}, "list");
  TEST_EQUALITY(list.get<int>("Steps"), 10);
  TEST_EQUALITY(list.sublist("Inner").get<std::string>("Law"), "None");
}

TEUCHOS_UNIT_TEST(Schema, validationNamesTheNearestKeyTypeAndRange) {
  TEST_ASSERT(contains(complaint(with("Tolerence", 0.5)), "'Tolerance'"));
  const std::string type = complaint(with("Steps", 0.5));
  TEST_ASSERT(contains(type, "Steps") && contains(type, "int") &&
              contains(type, "double"));
  for (const double outside : {1.0, std::nan("")}) {
    const std::string range = complaint(with("Tolerance", outside));
    TEST_ASSERT(contains(range, "Tolerance") && contains(range, "(0, 1)"));
  }
  const std::string least = complaint(with("Steps", 0));
  TEST_ASSERT(contains(least, "Steps") && contains(least, ">= 1"));
  ParameterList list;
  list.sublist("Inner").set<std::string>("Law", "Tersca");
  const std::string text = complaint(list);
  TEST_ASSERT(contains(text, "Inner->Law") && contains(text, "'Tresca'"));
}

TEUCHOS_UNIT_TEST(Schema, takesNumbersForTexts) {
  const std::vector<double> numbers = {0.25, 120000};
  const ParameterList all =
      bem::complete(rows(), with("Values", Teuchos::Array<double>(numbers)), "list");
  const auto& texts = all.get<Teuchos::Array<std::string>>("Values");
  TEST_EQUALITY(texts.size(), 2);
  TEST_EQUALITY(texts[0], "0.25");
  TEST_EQUALITY(texts[1], "120000");
}

TEUCHOS_UNIT_TEST(Schema, intervalsIncludeTheirClosedEndsOnly) {
  const bem::Interval halfOpen{0, 1, true, false};
  TEST_ASSERT(!halfOpen.contains(0) && halfOpen.contains(1) && !halfOpen.contains(2));
  TEST_ASSERT(!halfOpen.contains(std::nan("")));
}

}  // namespace epafi
