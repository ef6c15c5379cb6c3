#include "physics/dynamics/factor.h"

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
  factor.factor(values);
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
  factor.factor({2, 2, 2});

  const Eigen::VectorXd found = factor.solve(Eigen::Vector2d(3, 3));

  CHECK(2 * found[0] + 2 * found[1] == Approx(3));
}
