#include "app/scenario/scenario_bodies.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "app/toml/toml_values.h"
#include "engine/spacetime/lorentz.h"

namespace carom {
namespace {

std::vector<ScriptedLeg> readLegs(const TomlTable& body) {
  std::vector<ScriptedLeg> legs;
  double last_s = -std::numeric_limits<double>::infinity();
  for (const TomlTable& table : body.tables("leg")) {
    ScriptedLeg leg;
    if (legs.empty()) {
      table.refuse("from_s",
                   "has no meaning on the first leg, which reaches back to the beginning; expected none");
    } else {
      leg.from_s = table.number("from_s");
      if (table.has("from_s") && !(leg.from_s > last_s)) {
        table.fault("from_s", fmt::format("from_s is {}, expected a time after the leg before it, above {}",
                                          leg.from_s, last_s));
      }
      last_s = leg.from_s;
    }
    const Vec3 beta = toVec3(table.numbers<3>("beta"));
    checkSpeed(table, beta);
    leg.u = glm::dot(beta, beta) < 1.0 ? uFromBeta(beta) : Vec3(0.0);
    legs.push_back(leg);
  }
  if (legs.empty()) body.fault("leg", "there is no leg here, expected one [[body.leg]] at least");
  return legs;
}

/// Returns the centre at board time `t_s`, on a straight leg that it passes at `event`.
Event alongLeg(const Event& event, const Vec3& u, double t_s, double c_m_s) {
  return {t_s, event.r_m + betaFromU(u) * (c_m_s * (t_s - event.t_s))};
}

/// Returns the world line of a body whose centre passes `at`, on whichever leg holds that time: the events of
/// its turns follow from there in both directions. Its angle is 0 there.
WorldLine scriptedWorldLine(const BodyText& body, double c_m_s) {
  const std::vector<ScriptedLeg>& legs = body.legs;
  const Event& at = body.at;
  std::size_t holding = 0;
  while (holding + 1 < legs.size() && legs[holding + 1].from_s <= at.t_s) ++holding;
  std::vector<Event> begins(legs.size(), at);  // for the first leg, an event on it
  for (std::size_t i = holding; i > 0; --i) {
    begins[i] = alongLeg(i == holding ? at : begins[i + 1], legs[i].u, legs[i].from_s, c_m_s);
    begins[i - 1] = begins[i];
  }
  for (std::size_t i = holding + 1; i < legs.size(); ++i) {
    begins[i] = alongLeg(i == holding + 1 ? at : begins[i - 1], legs[i - 1].u, legs[i].from_s, c_m_s);
  }

  std::vector<Knot> knots;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    Knot knot{.turn = begins[i], .u = legs[i].u, .signal = begins[i]};
    if (i > 0) knot.properTime_s = motionOnLeg(knots.back(), knot.turn.t_s, c_m_s).properTime_s;
    knots.push_back(knot);
  }
  const double at_s = motionOnLeg(knots[holding], at.t_s, c_m_s).properTime_s;
  for (Knot& knot : knots)
    knot.spin = {angleAfter({0.0, body.spin_rad_s}, knot.properTime_s - at_s), body.spin_rad_s};

  // The clock shows 0 where the body appears, or at board time 0.
  const double zero_s = body.appears_s.value_or(0.0);
  const auto holdsZero = std::find_if(knots.rbegin(), knots.rend() - 1,
                                      [&](const Knot& knot) { return knot.turn.t_s <= zero_s; });
  const double shown_s = motionOnLeg(*holdsZero, zero_s, c_m_s).properTime_s;
  for (Knot& knot : knots) knot.properTime_s -= shown_s;

  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  WorldLine line(knots.front(), c_m_s, kInfinity, body.appears_s.value_or(-kInfinity));
  for (std::size_t i = 1; i < knots.size(); ++i) line.append(knots[i]);
  return line;
}

/// The table of a history, and its faults.
class HistoryText {
 public:
  HistoryText(const std::filesystem::path& file, double c_m_s)
      : file_(file.string()), c_m_s_(c_m_s), text_(readText(file, InputKind::trace)) {}

  void read() {
    constexpr std::string_view kMark = "\xEF\xBB\xBF";  // of UTF-8, which table programs write
    std::size_t begin = text_.starts_with(kMark) ? kMark.size() : 0;
    for (line_ = 1; begin < text_.size() && faults_.size() < kMostFindings; ++line_) {
      const std::size_t end = std::min(text_.find('\n', begin), text_.size());
      std::string_view row = std::string_view(text_).substr(begin, end - begin);
      if (row.ends_with('\r')) row.remove_suffix(1);
      begin = end + 1;
      if (line_ == 1) {
        readHeader(row);
      } else if (!row.empty() || begin < text_.size()) {
        readRow(row);
      }
    }
    if (faults_.empty() && times_s.size() < 2)
      fault(1, fmt::format("the history has {}, expected two rows at least",
                           times_s.empty() ? "no row" : "one row"));
    if (!faults_.empty()) throw InputErrors(std::move(faults_));
  }

  std::vector<double> times_s;
  std::vector<Vec3> places_m;

 private:
  void fault(std::size_t column, std::string what) {
    faults_.emplace_back(file_, line_, static_cast<int>(column), std::move(what));
  }

  void readHeader(std::string_view row) {
    std::string expected = "t_s";
    for (vertices_ = 0; expected.size() < row.size(); ++vertices_)
      expected += fmt::format(",x{0}_m,y{0}_m,z{0}_m", vertices_);
    if (row == expected && vertices_ > 0) return;
    const auto differs = std::mismatch(row.begin(), row.end(), expected.begin(), expected.end()).first;
    fault(static_cast<std::size_t>(differs - row.begin()) + 1,
          "the first line does not name the columns, expected t_s,x0_m,y0_m,z0_m,x1_m,… with three for each "
          "vertex");
    throw InputErrors(std::move(faults_));
  }

  void readRow(std::string_view row) {
    std::vector<double> numbers;
    std::vector<std::size_t> columns;
    const std::size_t wanted = 1 + 3 * vertices_;
    for (std::size_t begin = 0; begin <= row.size() && numbers.size() <= wanted;) {
      const std::size_t end = std::min(row.find(',', begin), row.size());
      const std::optional<double> number = wholeNumber(row.substr(begin, end - begin));
      if (!number || !(std::abs(*number) <= kFurthest)) {
        return fault(
            begin + 1,
            fmt::format("'{}' is no number from -1e9 to 1e9, expected one",
                        printable(std::string(row.substr(begin, std::min<std::size_t>(end - begin, 40))))));
      }
      numbers.push_back(*number);
      columns.push_back(begin + 1);
      begin = end + 1;
    }
    if (numbers.size() != wanted)
      return fault(
          1, fmt::format("the row has {} numbers, expected {}: a time and three for each of {} vertices",
                         numbers.size() > wanted ? "more than " + std::to_string(wanted)
                                                 : std::to_string(numbers.size()),
                         wanted, vertices_));
    if (!times_s.empty() && !(numbers[0] > times_s.back()))
      return fault(1, fmt::format("t_s is {} after {}, expected rows in the order of time", numbers[0],
                                  times_s.back()));
    for (std::size_t v = 0; v < vertices_; ++v) {
      const Vec3 place_m(numbers[3 * v + 1], numbers[3 * v + 2], numbers[3 * v + 3]);
      if (!times_s.empty()) checkSpeedOf(v, place_m, numbers[0], columns[3 * v + 1]);
      row_.push_back(place_m);
    }
    places_m.insert(places_m.end(), row_.begin(), row_.end());
    row_.clear();
    times_s.push_back(numbers[0]);
  }

  void checkSpeedOf(std::size_t vertex, const Vec3& place_m, double t_s, std::size_t column) {
    const Vec3 before_m = places_m[places_m.size() - vertices_ + vertex];
    const double speed = glm::length(place_m - before_m) / (c_m_s_ * (t_s - times_s.back()));
    if (speed < 1.0) return;
    fault(column,
          fmt::format("vertex {} moves at {:.6g} c from the row before to row {}, expected less than light",
                      vertex, speed, times_s.size() + 1));
  }

  std::string file_;
  double c_m_s_;
  std::string text_;
  int line_ = 1;
  std::size_t vertices_ = 0;
  std::vector<Vec3> row_;
  std::vector<InputError> faults_;
};

/// Returns the number of vertices of an .obj file; none for another kind of file.
std::optional<std::size_t> objVertices(const std::filesystem::path& mesh) {
  if (mesh.extension() != ".obj") return {};
  const std::string text = readText(mesh, InputKind::mesh);
  std::size_t count = text.starts_with("v ") ? 1 : 0;
  for (std::size_t at = text.find("\nv "); at != std::string::npos; at = text.find("\nv ", at + 1)) ++count;
  return count;
}

/// Returns the triangles of an .obj file of so many vertices: polygons are fans. Refuses at `table` a corner
/// that is none of the vertices, which are counted from 1, or from the last backwards.
std::vector<std::array<std::uint32_t, 3>> objTriangles(const std::filesystem::path& mesh,
                                                       std::size_t vertices, const TomlTable& table) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::istringstream text(readText(mesh, InputKind::mesh));
  std::vector<std::uint32_t> corners;
  int number = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    if (!line.starts_with("f ")) continue;
    corners.clear();
    std::istringstream words(line.substr(2));
    for (std::string word; words >> word;) {
      const std::string first = word.substr(0, word.find('/'));
      long corner = 0;
      const auto [end, fault] = std::from_chars(first.data(), first.data() + first.size(), corner);
      if (corner < 0) corner += static_cast<long>(vertices) + 1;
      const bool isOne = fault == std::errc() && end == first.data() + first.size() && corner >= 1 &&
                         corner <= static_cast<long>(vertices);
      if (!isOne) {
        table.fault("mesh", fmt::format("{}:{}:1: '{}' is no vertex of the mesh, expected 1 to {}",
                                        mesh.string(), number, word, vertices));
        return {};
      }
      corners.push_back(static_cast<std::uint32_t>(corner - 1));
    }
    for (std::size_t k = 2; k < corners.size(); ++k)
      triangles.push_back({corners[0], corners[k - 1], corners[k]});
  }
  return triangles;
}

}  // namespace

std::optional<std::filesystem::path> readMesh(const TomlFile& file, const TomlTable& table) {
  if (!table.has("mesh")) return {};
  return file.existingFile(table, "mesh", InputKind::mesh, Reach::ownFolder);
}

BodyText readBody(const TomlFile& file, const TomlTable& table) {
  BodyText body{table, table.text("name"), readMesh(file, table), {}, {}, {}, 0.0, {}, {}};
  if (table.has("history")) {
    for (const char* key : {"material", "at", "leg", "appears_s", "spin_rad_s"})
      table.refuse(key, "stands beside history, expected one of them");
    body.history = file.existingFile(table, "history", InputKind::trace, Reach::ownFolder);
    return body;
  }
  if (table.has("material") && !body.mesh)
    table.fault("material", "material is of a mesh, expected the key mesh, too");
  body.material = static_cast<Material>(table.choice("material"));
  if (const auto at = table.requiredTable("at")) {
    body.at = {at->number("t_s"), toVec3(at->numbers<3>("r_m"))};
  }
  if (table.has("appears_s")) body.appears_s = table.number("appears_s");
  body.spin_rad_s = table.number("spin_rad_s");
  body.legs = readLegs(table);
  return body;
}

ToldBody toldBody(const BodyText& body, double c_m_s) {
  HistoryText rows(*body.history, c_m_s);
  rows.read();
  const std::size_t vertices = rows.places_m.size() / rows.times_s.size();
  ToldBody told{body.name, SampledHistory(c_m_s, std::move(rows.times_s), std::move(rows.places_m))};
  if (!body.mesh) return told;
  if (const std::optional<std::size_t> count = objVertices(*body.mesh); count == vertices) {
    told.triangles = objTriangles(*body.mesh, vertices, body.table);
  } else {
    body.table.fault(
        "mesh",
        count ? fmt::format("the mesh has {} vertices and the history of '{}' {}, expected as many", *count,
                            body.name, vertices)
              : "the mesh is no .obj file, expected one with the vertices of the history in their order");
  }
  return told;
}

ScriptedBody scriptedBody(const BodyText& body, double c_m_s) {
  return {body.name, scriptedWorldLine(body, c_m_s), body.mesh, body.material, body.mesh || !body.holds};
}

}  // namespace carom
