#include "physics/dynamics/factor.h"

#include <Eigen/Cholesky>

#include <catch2/catch.hpp>

using namespace tumble;
using dynamics::Factor;

namespace {

// A chain's matrix: each row meets its neighbours.
void make(Factor& factor, int size, Eigen::MatrixXd& full) {
  std::vector<std::pair<int, int>> pattern;
  std::vector<double> values;
  full.setZero(size, size);
  for (int i = 0; i < size; ++i)
    for (int j = std::max(0, i - 2); j <= i; ++j) {
      const double value = i == j ? 3 + 0.1 * i : 0.3 / (1 + i - j);
      pattern.emplace_back(i, j);
      values.push_back(value);
      full(i, j) = full(j, i) = value;
    }
  factor.set_pattern(size, pattern);
  factor.factor(values, 1e-10);
}

}  // namespace

TEST_CASE("factor: few rows and many are solved alike", "[physics][dynamics]") {
  for (const int size : {1, 5, 12, 13, 200}) {
    Factor factor;
    Eigen::MatrixXd full;
    make(factor, size, full);
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(size, -1, 2);

    const Eigen::VectorXd found = factor.solve(full * x);

    INFO(size << " rows");
    CHECK((found - x).norm() < 1e-8 * x.norm());  // what is added to the diagonal, 1e-10 of it
  }
}

TEST_CASE("factor: rows that say the same twice still have a solution", "[physics][dynamics]") {
  Factor factor;
  factor.set_pattern(2, {{0, 0}, {1, 0}, {1, 1}});
  factor.factor({2, 2, 2}, 1e-10);

  const Eigen::VectorXd found = factor.solve(Eigen::Vector2d(3, 3));

  CHECK(2 * found[0] + 2 * found[1] == Approx(3));
}

namespace {

// Of a net of side x side knots, each tied to its neighbours by three rows; where ties share a knot, their rows meet.
int make_net(Factor& factor, int side, Eigen::MatrixXd& full) {
  std::vector<std::pair<int, int>> ties;
  for (int i = 0; i < side * side; ++i) {
    if (i % side > 0) ties.emplace_back(i - 1, i);
    if (i >= side) ties.emplace_back(i - side, i);
  }
  const int size = 3 * static_cast<int>(ties.size());
  std::vector<std::pair<int, int>> pattern;
  std::vector<double> values;
  full.setZero(size, size);
  for (int i = 0; i < size; ++i)
    for (int j = 0; j <= i; ++j) {
      const auto &x = ties[static_cast<std::size_t>(i / 3)], &y = ties[static_cast<std::size_t>(j / 3)];
      if (x.first != y.first && x.first != y.second && x.second != y.first && x.second != y.second) continue;
      const double value = i == j ? 12 : 0.5 * std::sin(1.0 + i * 7 + j * 3);
      pattern.emplace_back(i, j);
      values.push_back(value);
      full(i, j) = full(j, i) = value;
    }
  factor.set_pattern(size, pattern);
  factor.factor(values, 1e-10);
  return size;
}

}  // namespace

TEST_CASE("factor: nets are solved as full matrices are", "[physics][dynamics]") {
  for (const int side : {3, 4, 9}) {
    Factor factor;
    Eigen::MatrixXd full;
    const int size = make_net(factor, side, full);
    REQUIRE(Eigen::LLT<Eigen::MatrixXd>(full).info() == Eigen::Success);
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(size, -1, 2);

    INFO(side << " knots a side");
    CHECK((factor.solve(full * x) - x).norm() < 1e-8 * x.norm());
  }
}

TEST_CASE("factor: rows that say the same twice share what one would take", "[physics][dynamics]") {
  constexpr int rows = 20;  // more than are solved as a full matrix
  Factor factor;
  std::vector<std::pair<int, int>> pattern;
  std::vector<double> values;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j <= i; ++j) {
      pattern.emplace_back(i, j);
      values.push_back(2);
    }
  factor.set_pattern(rows, pattern);
  factor.factor(values, 1e-10);

  const Eigen::VectorXd shares = factor.solve(Eigen::VectorXd::Constant(rows, 6));

  CHECK(shares.sum() == Approx(3).epsilon(1e-6));
  CHECK((shares.array() - 3.0 / rows).abs().maxCoeff() < 1e-3);
}
