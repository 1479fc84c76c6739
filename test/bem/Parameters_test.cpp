#include "bem/base/Parameters.hpp"

#include "bem/base/Error.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_UnitTestHarness.hpp>

#include <cmath>

namespace epafi {

namespace {

using Teuchos::ParameterList;

ParameterList valid() {
  ParameterList list("valid");
  list.set("Tolerance", 1e-6, "accuracy", bem::inInterior(0, 1));
  list.set("Steps", 10, "how many", bem::atLeast(1));
  list.sublist("Inner").set<std::string>("Law", "None", "law",
                                         bem::oneOf({"None", "Tresca"}));
  return list;
}

std::string complaint(ParameterList list) {
  try {
    bem::validate(list, valid());
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

TEUCHOS_UNIT_TEST(Parameters, editDistanceCountsTheFewestChanges) {
  TEST_EQUALITY(bem::editDistance("Degree", "Degree"), 0.0);
  TEST_EQUALITY(bem::editDistance("Degre", "Degree"), 1.0);
  TEST_EQUALITY(bem::editDistance("Dergee", "Degree"), 1.0);  // neighbours swapped
  TEST_EQUALITY(bem::editDistance("degree", "Degree"), 0.5);
  TEST_EQUALITY(bem::editDistance("kitten", "sitting"), 3.0);
  TEST_EQUALITY(bem::editDistance("", "abc"), 3.0);
  TEST_EQUALITY(bem::nearest("Gama0", {"Beta", "Gamma0", "Eta"}), "Gamma0");
  // Candidates that are too long to be the nearest do not hide those that are not.
  TEST_EQUALITY(bem::nearest("Gam", {"Gamma0 of the stabilisation", "Beta", "Gamma0"}),
                "Gamma0");
  TEST_EQUALITY(bem::nearest("Tolerance of the solver", {"x", "Tolerance", "Solver"}),
                "Tolerance");
  TEST_EQUALITY(bem::nearest("x", {}), "");
}

TEUCHOS_UNIT_TEST(Parameters, validationFillsInDefaultsOnAllLevels) {
  ParameterList list;
  bem::validate(list, valid());
  TEST_EQUALITY(list.get<int>("Steps"), 10);
  TEST_EQUALITY(list.sublist("Inner").get<std::string>("Law"), "None");
}

TEUCHOS_UNIT_TEST(Parameters, validationNamesTheNearestKeyTypeAndRange) {
  TEST_ASSERT(contains(complaint(with("Tolerence", 0.5)), "'Tolerance'"));
  const std::string type = complaint(with("Tolerance", 1));
  TEST_ASSERT(contains(type, "Tolerance") && contains(type, "int") &&
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

TEUCHOS_UNIT_TEST(Parameters, intervalsIncludeTheirClosedEndsOnly) {
  const bem::Interval halfOpen{0, 1, true, false};
  TEST_ASSERT(!halfOpen.contains(0) && halfOpen.contains(1) && !halfOpen.contains(2));
  TEST_ASSERT(!halfOpen.contains(std::nan("")));
}

}  // namespace epafi
