#include "bem/base/Schema.hpp"

#include "Message.hpp"
#include "bem/base/Acceptor.hpp"
#include "bem/base/Suggestion.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>
#include <Teuchos_TwoDArray.hpp>
#include <Teuchos_UnitTestHarness.hpp>

namespace epafi {

namespace {

using Teuchos::ParameterList;

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
  // capitals are no mistakes, and of a side its body may be missing
  TEST_EQUALITY(bem::nearest("mesh size", {"Vertices", "Mesh Size"}), "Mesh Size");
  TEST_EQUALITY(bem::meant("lap", {"map", "upper:lap"}), "; did you mean 'upper:lap'?");
  TEST_EQUALITY(bem::meant("Mesh Size", {"Bodies", "Contacts"}), "");
}

TEUCHOS_UNIT_TEST(Schema, takesNumbersForTexts) {
  const std::vector<double> numbers = {0.25, 120000};
  const bem::SchemaRows rows = {bem::Row("Values", bem::Kind::Names, "texts")};
  const ParameterList all =
      bem::complete(rows, with("Values", Teuchos::Array<double>(numbers)), "list");
  const auto& texts = all.get<Teuchos::Array<std::string>>("Values");
  TEST_EQUALITY(texts.size(), 2);
  TEST_EQUALITY(texts[0], "0.25");
  TEST_EQUALITY(texts[1], "120000");
}

/// Keys of all sorts, each of which is declared once.
struct Part {
  double size = 0.25;
  void keys(bem::Keys& keys) {
    keys.add(&size, "Size", "length", bem::above(0), "of a part");
  }
};
enum class Shape { Round, Square };
constexpr bem::Named<Shape> shapes[] = {{"Round", Shape::Round},
                                        {"Square", Shape::Square}};
struct Options {
  Part part;
  int count = 3;
  bool hollow = false;
  std::optional<double> weight;
  Shape shape = Shape::Square;
  std::string color = "Red";
  std::vector<bem::Vec2> points;
  void keys(bem::Keys& keys) {
    keys.add(&count, "Count", "1", {1, 9}, "of parts");
    keys.add(&hollow, "Hollow", "", {}, "inside");
    keys.add(&weight, "Weight", "mass", bem::from(0), "of all", "1.5");
    keys.add(&shape, "Shape", shapes, "of each");
    keys.add(&color, "Color", {"Red", "Blue"}, "outside");
    keys.add(&points, "Points", "length", {}, "of contact");
    keys.add(&part, bem::Row("Part", bem::Kind::List, "one of them"));
  }
};

TEUCHOS_UNIT_TEST(Schema, aKeyDeclaredOnceHasItsMembersDefaultAndSetsIt) {
  const bem::SchemaRows rows = bem::rowsOf<Options>();
  TEST_EQUALITY(bem::declared(rows, "Part->Size").defaultValue, "0.25");
  TEST_EQUALITY(bem::declared(rows, "Shape").defaultValue, "Square");
  const auto plain = bem::parsed<Options>(bem::complete(rows, {}, ""));
  TEST_EQUALITY(plain.count, 3);
  TEST_EQUALITY(plain.color, "Red");
  TEST_ASSERT(!plain.weight && plain.points.empty() && plain.shape == Shape::Square);

  ParameterList list = with("Count", 4);
  list.set("Hollow", true)
      .set("Weight", 1.5)
      .set("Points", Teuchos::TwoDArray<int>(3, 2, 7));
  list.set<std::string>("Shape", "Round").set<std::string>("Color", "Blue");
  list.sublist("Part").set("Size", 1);
  const auto given = bem::parsed<Options>(bem::complete(rows, list, ""));
  TEST_ASSERT(given.hollow && given.weight == 1.5 && given.shape == Shape::Round);
  TEST_EQUALITY(given.count, 4);
  TEST_EQUALITY(given.color, "Blue");
  TEST_EQUALITY(given.part.size, 1);
  TEST_EQUALITY(given.points.size(), 3u);
  TEST_EQUALITY(given.points[2].y, 7);
  TEST_THROW(bem::complete(rows, with("Count", 10), ""), bem::InputError);
}

/// As a class of Trilinos: what a list does not say stays, and the list then has it.
TEUCHOS_UNIT_TEST(Schema, whatAcceptsListsHasValidParameters) {
  class Widget final : public bem::Acceptor<Options> {
   public:
    using Acceptor::Acceptor;
  };
  Options start;
  start.count = 5;
  Widget widget(start);
  const auto valid = widget.getValidParameters();
  TEST_EQUALITY(valid->get<int>("Count"), 5);
  TEST_EQUALITY(valid->sublist("Part").get<double>("Size"), 0.25);
  TEST_ASSERT(test::contains(valid->getEntry("Count").docString(), "of parts"));

  const auto list = Teuchos::rcp(new Teuchos::ParameterList("Widget"));
  list->set<std::string>("Color", "Blue");
  list->validateParameters(*valid);
  widget.setParameterList(list);
  TEST_ASSERT(widget.getParameterList() == list);
  TEST_EQUALITY(widget.options().color, "Blue");
  TEST_EQUALITY(widget.options().count, 5);
  TEST_EQUALITY(list->get<int>("Count"), 5);
  TEST_ASSERT(!widget.options().weight);
  list->validateParameters(*valid);

  for (const auto& [wrong, told] :
       {std::pair(with("Count", 10), "List->Count = 10; allowed"),
        std::pair(with("Cuont", 4), "List->Cuont: unknown")}) {
    const auto refused = Teuchos::rcp(new Teuchos::ParameterList(wrong));
    refused->setName("List");
    TEST_THROW(refused->validateParameters(*valid), std::logic_error);
    TEST_ASSERT(
        test::contains(test::messageOf([&] { widget.setParameterList(refused); }), told));
    TEST_EQUALITY(widget.options().count, 5);
  }
}

TEUCHOS_UNIT_TEST(Schema, textsInPlaceOfNumbersAreConstants) {
  const auto length = [](const std::string& text, const std::string&) {
    return static_cast<double>(text.size());
  };
  const bem::SchemaRows rows = bem::rowsOf<Options>();
  const auto options = bem::parsed<Options>(
      bem::complete(rows, with<std::string>("Count", "abcd"), "", length));
  TEST_EQUALITY(options.count, 4);
  TEST_THROW(bem::complete(rows, with<std::string>("Count", "abcd"), ""),
             bem::InputError);
  const auto half = [](const std::string&, const std::string&) { return 2.5; };
  TEST_THROW(bem::complete(rows, with<std::string>("Count", "a"), "", half),
             bem::InputError);
}

TEUCHOS_UNIT_TEST(Schema, intervalsIncludeTheirClosedEndsOnly) {
  const bem::Interval halfOpen{0, 1, true, false};
  TEST_ASSERT(!halfOpen.contains(0) && halfOpen.contains(1) && !halfOpen.contains(2));
  TEST_ASSERT(!halfOpen.contains(std::nan("")));
}

}  // namespace epafi
