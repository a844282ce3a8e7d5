#include "proofs/certificates/path_certificate.hpp"

#include "proofs/exact/as_double.hpp"
#include "proofs/paths/followed_path.hpp"
#include "proofs/paths/measures.hpp"
#include "tests/proofs/certificates/stand_alone.hpp"
#include "tests/property.hpp"

using namespace plumbline;
using namespace plumbline::proofs;
using nlohmann::json;

namespace {

/// What is proved of a path, all branches or the slow loading.
json certified(const Chain<Rational>& chain, Control control, const Point<Rational>& direction, double last,
               bool all) {
  const auto exact = from_rational<Interval>(chain);
  const Interval x(direction.x), y(direction.y), size = sqrt(sqr(x) + sqr(y));
  Loading<Interval> loading{control, {0, 0}, {x / size, y / size}};
  if (control == Control::end_point) loading.start = end_point(exact, exact.rest());
  const PathTask task{convert<double>(exact, as_double),
                      {control,
                       {as_double(loading.start.x), as_double(loading.start.y)},
                       {as_double(loading.direction.x), as_double(loading.direction.y)}},
                      last,
                      0.2};
  const PathReport followed = all ? follow_all(task) : follow_slowly(task);
  const JoinedBranches proved =
      certify(followed, exact, loading, symmetries(chain, control, direction), ProvedPoints::rounded);
  return path_certificate({"test", chain, false, control, direction}, proved);
}

std::size_t folds(const json& certificate) {
  std::size_t count = 0;
  for (const json& part : certificate["parts"]) count += part["folds"].size();
  return count;
}

}  // namespace

TEST_CASE(
    "the stand-alone checker confirms paths: jumps, folds, pitchforks, passive bases, forces, any units") {
  const Rational half(1, 2);
  const Chain<Rational> snap({1, 1, 1, 1}, {5, 5, 5, 6},
                             {Rational(3, 5), Rational(-6, 5), Rational(3, 5), 0});
  const Chain<Rational> zigzag({1, 1, 1}, {0, 1, 1}, {Rational(-1, 10), Rational(3, 10), Rational(-3, 10)});
  const Chain<Rational> unequal({1, Rational(3, 2)}, {1, half}, {half, -1});
  const Chain<Rational> scaled({1000, 1500}, {Rational(1, 100000), half / 100000}, {half, -1});
  const Chain<Rational> straight({1, 1, 1}, {1, 1, 1});
  const std::vector<json> certificates{
      certified(snap, Control::end_point, {-2, 0}, 1.16, false),
      certified(zigzag, Control::end_point, {-1, 0}, 0.3, false),
      certified(unequal, Control::end_point, {-1, 1}, 0.5, true),
      certified(unequal, Control::force, {-1, Rational(1, 10)}, 1.5, false),
      certified(zigzag, Control::end_point, {-1, 0}, 0.1, true),
      certified(straight, Control::force, {-1, 0}, 0.5, false),
      certified(scaled, Control::force, {-1, Rational(1, 10)}, 1.5e-8, false)};
  CHECK(folds(certificates[0]) > 0);
  CHECK(certificates[1]["parts"].size() == 2);
  for (const std::size_t i : {1, 4, 5}) CHECK(certificates[i]["pitchforks"].size() == 1);
  for (const json& one : certificates) CHECK(check_alone("check_paths.py", path_certificates, {one}) == 0);
}

TEST_CASE(
    "a certificate states what was given, the runs of each part, and the parts that meet in a pitchfork") {
  const Rational tenth(1, 10);
  const Chain<Rational> unequal({1, Rational(3, 2)}, {1, Rational(1, 2)}, {Rational(1, 2), -1});
  const json pressed = certified(unequal, Control::force, {-1, tenth}, 0.5, false);
  CHECK(pressed["case"] == "test");
  CHECK(pressed["lengths"] == json{"1", "1.5"});
  CHECK(pressed["stiffness"] == json{"1", "0.5"});
  CHECK(pressed["rest"] == json{"0.5", "-1"});
  CHECK(pressed["rest_unit"] == "rad");
  CHECK(pressed["control"] == "force");
  CHECK(pressed["direction"] == json{"-1", "0.1"});
  CHECK(pressed["pitchforks"].empty());
  // stable, and the load grows all the way
  REQUIRE(pressed["parts"].size() == 1);
  CHECK(pressed["parts"][0]["runs"] == json::array({{1, 0}}));
  CHECK(pressed["parts"][0]["folds"].empty());
  const json& points = pressed["parts"][0]["points"];
  REQUIRE(points.size() > 1);
  const auto number = [](const json& decimal) { return std::stod(decimal.get<std::string>()); };
  // two angles and the load, in the unit of the chain
  for (const json& point : points) REQUIRE(point.size() == 3);
  CHECK(number(points.front()[2]) == 0);
  const double unit = load_unit(from_rational<Interval>(unequal), Control::force);
  CHECK(std::abs(number(points.back()[2]) * unit - 0.5) <
        1e-8);  // the ninth decimal, in the unit of the chain
  const double near = number(pressed["parts"][0]["near"]);
  CHECK(near >= 2e-9);
  CHECK(near < 1e-6);

  // The zigzag keeps theta_1 = theta_3 while it lasts, and the arches that leave it do not.
  const json forked = certified(Chain<Rational>({1, 1, 1}, {0, 1, 1}, {-tenth, 3 * tenth, -3 * tenth}),
                                Control::end_point, {-1, 0}, 0.1, true);
  CHECK(forked["control"] == "end_point");
  REQUIRE(forked["pitchforks"].size() == 1);
  const json& fork = forked["pitchforks"][0];
  CHECK(fork["symmetry"] == "reversed");
  CHECK(fork["symmetric"].size() == 2);
  CHECK(fork["bent"].size() == 2);
  for (const bool symmetric : {true, false}) {
    for (const json& end : fork[symmetric ? "symmetric" : "bent"]) {
      const std::size_t part = end[0];
      REQUIRE(part >= 1);
      REQUIRE(part <= forked["parts"].size());
      const json& all = forked["parts"][part - 1]["points"];
      const json& point = end[1] == "first" ? all.front() : all.back();
      CHECK((end[1] == "first" || end[1] == "last"));
      const double aside = std::abs(number(point[0]) - number(point[2]));
      CHECK((aside < 1e-8) == symmetric);
      // the ends of a gap about the crossing, on both sides of it or, where the branch bends, on one
      CHECK(std::abs(number(point.back()) - number(fork["load"][0])) < 0.05);
    }
  }
  CHECK(number(fork["load"][0]) <= number(fork["load"][1]));
}

TEST_CASE("points that are proved rounded have nine decimals, and those that are followed have more") {
  const Chain<Rational> chain({1, Rational(3, 2)}, {1, Rational(1, 2)}, {Rational(1, 2), -1});
  const auto exact = from_rational<Interval>(chain);
  const Loading<Interval> loading{Control::end_point, end_point(exact, exact.rest()), {-1, 0}};
  const Point<double> start{as_double(loading.start.x), as_double(loading.start.y)};
  const PathTask task{convert<double>(exact, as_double), {Control::end_point, start, {-1, 0}}, 0.5, 0.2};
  const auto decimals_end = [&](ProvedPoints points) {
    const JoinedBranches proved = certify(follow_slowly(task), exact, loading, {}, points);
    REQUIRE_FALSE(proved.branches.at(0).pieces.empty());
    const ProvedPiece& piece = proved.branches[0].pieces[0];
    std::vector<bool> end(static_cast<std::size_t>(piece.points[0].size()), true);
    for (const Vector<double>& point : piece.points) {
      REQUIRE(point.size() == 5);
      for (Eigen::Index i = 0; i < point.size(); ++i) {
        // a double of size one times 1e9 is off by 1e-7
        const double more = std::abs(point(i) * 1e9 - std::round(point(i) * 1e9));
        if (more > 1e-5) end[static_cast<std::size_t>(i)] = false;
      }
    }
    return end;
  };
  CHECK(decimals_end(ProvedPoints::rounded) == std::vector<bool>(5, true));
  CHECK(decimals_end(ProvedPoints::as_followed) == std::vector<bool>(5, false));
}

TEST_CASE(
    "a certificate rounds points to nine decimals, and widens what it says of folds, forks and distances") {
  ProvedPiece piece;
  piece.points = {Vector<double>(3), Vector<double>(3)};
  piece.points[0] << 0.1234567894, -0.0000000004, 2;
  piece.points[1] << 0.1234567896, -0.25, 1e-9;
  piece.runs = {{1, 2, 0}, {2, 0.5, 3}};
  piece.folds = {Span(2, 2.00002)};
  piece.distance = 1.25e-9;
  PathCertificate one, two;
  one.pieces = {piece, piece};
  two.pieces = {piece};
  // the unit of a force is max k / max L = 2
  const PathGiven given{"made up", Chain<Rational>({4, 1}, {8, 2}), true, Control::force, {-1, 0}};
  const std::vector<EndOfPiece> symmetric{{0, 1, true}, {1, 0, false}}, bent{{0, 0, false}};
  JoinedBranches all{{one, two}, {}};
  for (const auto& [reversed, mirrored] : {std::pair{true, false}, {false, true}, {true, true}})
    all.forks.push_back({Span(2, 2.2), {reversed, mirrored}, symmetric, bent});
  const json stated = path_certificate(given, all);
  CHECK(stated["rest_unit"] == "pi");
  REQUIRE(stated["parts"].size() == 3);
  for (const json& part : stated["parts"]) {
    CHECK(part["points"] == json::array({{"0.123456789", "0", "2"}, {"0.12345679", "-0.25", "0.000000001"}}));
    CHECK(part["runs"] == json::array({{1, 0}, {-1, 3}}));
    // a tenth of the width, 2e-6, and a billionth of the size, 2e-9, to either side, rounded outwards
    CHECK(part["folds"] == json::array({{"1.999997997", "2.000022003"}}));
    // twice 1.25e-9 and 2e-9, rounded up
    CHECK(part["near"] == "0.000000005");
  }
  REQUIRE(stated["pitchforks"].size() == 3);
  CHECK(stated["pitchforks"][0]["symmetry"] == "reversed");
  CHECK(stated["pitchforks"][1]["symmetry"] == "mirrored");
  CHECK(stated["pitchforks"][2]["symmetry"] == "reversed and mirrored");
  for (const json& fork : stated["pitchforks"]) {
    // from 1 to 1.1, a hundredth and 1.1e-9 wider, and a last place for the rounding of the room
    CHECK(std::abs(std::stod(fork["load"][0].get<std::string>()) - (0.99 - 1.1e-9)) < 1.1e-9);
    CHECK(std::abs(std::stod(fork["load"][1].get<std::string>()) - (1.11 + 1.1e-9)) < 1.1e-9);
    // parts are counted over all branches
    CHECK(fork["symmetric"] == json::array({{2, "last"}, {3, "first"}}));
    CHECK(fork["bent"] == json::array({{1, "first"}}));
  }
  all.branches[1].failed_at = Span(1);
  all.branches[1].failure = "something";
  CHECK_THROWS_WITH_AS(path_certificate(given, all),
                       "certificate: found something, expected a path that is proved", Error);
}
