#include "physics/dynamics/fronts.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include <algorithm>

namespace tumble::dynamics {

namespace {

using Table = Eigen::Map<Eigen::MatrixXd>;

constexpr int kPanel = 24;              // columns that are eliminated before the rest of a front is told
constexpr double kLeastPivot = 1e-13;   // part of what was on the diagonal

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Rows below the diagonal in each column, in an order of elimination.
std::vector<std::vector<int>> columns_of(int size, const std::vector<std::pair<int, int>>& entries, const std::vector<int>& order) {
  std::vector<std::vector<int>> columns(at(size));
  for (const auto& [row, column] : entries) {
    const int i = order[at(row)], j = order[at(column)];
    if (i != j) columns[at(std::min(i, j))].push_back(std::max(i, j));
  }
  for (std::vector<int>& rows : columns) std::sort(rows.begin(), rows.end());
  return columns;
}

// Adds the rows that elimination fills; a column's parent is its first row.
std::vector<int> fill_in(std::vector<std::vector<int>>& columns) {
  std::vector<int> parents(columns.size(), -1), sum;
  for (std::size_t j = 0; j < columns.size(); ++j) {
    if (columns[j].empty()) continue;
    const int parent = parents[j] = columns[j].front();
    sum.clear();
    std::set_union(columns[j].begin() + 1, columns[j].end(), columns[at(parent)].begin(), columns[at(parent)].end(), std::back_inserter(sum));
    columns[at(parent)] = sum;
  }
  return parents;
}

// Where each column goes, so that all below a parent in the tree are right before it: from the end, parents first.
std::vector<int> postorder(const std::vector<int>& parents) {
  std::vector<std::vector<int>> children(parents.size() + 1);
  for (std::size_t i = parents.size(); i-- > 0;) children[parents[i] < 0 ? parents.size() : at(parents[i])].push_back(static_cast<int>(i));
  std::vector<int> place(parents.size()), open = children.back();
  int next = static_cast<int>(parents.size());
  while (!open.empty()) {
    const int column = open.back();
    open.pop_back();
    place[at(column)] = --next;
    open.insert(open.end(), children[at(column)].begin(), children[at(column)].end());
  }
  return place;
}

}  // namespace

void Fronts::analyze(int size, const std::vector<std::pair<int, int>>& entries) {
  size_ = size;
  std::vector<Eigen::Triplet<double>> triplets;
  for (const auto& [row, column] : entries) {
    triplets.emplace_back(row, column, 1.0);
    if (row != column) triplets.emplace_back(column, row, 1.0);
  }
  Eigen::SparseMatrix<double> whole(size, size);
  whole.setFromTriplets(triplets.begin(), triplets.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> inverse;
  Eigen::AMDOrdering<int>()(whole, inverse);
  order_.resize(at(size));
  for (int i = 0; i < size; ++i) order_[at(inverse.indices()[i])] = i;

  std::vector<std::vector<int>> columns = columns_of(size, entries, order_);
  const std::vector<int> place_of = postorder(fill_in(columns));
  for (int& when : order_) when = place_of[at(when)];
  columns = columns_of(size, entries, order_);
  fill_in(columns);
  join(columns);
  place(entries);
}

// Columns whose rows are those of the next one, and it, are one front.
void Fronts::join(const std::vector<std::vector<int>>& columns) {
  fronts_.clear();
  for (int j = 0; j < size_; ++j) {
    const bool same = j > 0 && !columns[at(j) - 1].empty() && columns[at(j) - 1].front() == j && columns[at(j) - 1].size() == columns[at(j)].size() + 1;
    if (!same) {
      fronts_.emplace_back();
      fronts_.back().first = j;
      fronts_.back().rows = {j};
      fronts_.back().rows.insert(fronts_.back().rows.end(), columns[at(j)].begin(), columns[at(j)].end());
    }
    ++fronts_.back().width;
  }
}

// Where each front's numbers come from and go to.
void Fronts::place(const std::vector<std::pair<int, int>>& entries) {
  std::vector<int> front_of(at(size_));
  std::size_t blocks = 0, most = 0;
  for (std::size_t f = 0; f < fronts_.size(); ++f) {
    Front& front = fronts_[f];
    for (int j = front.first; j < front.first + front.width; ++j) front_of[at(j)] = static_cast<int>(f);
    front.block = blocks;
    blocks += front.rows.size() * at(front.width);
    most = std::max(most, front.rows.size());
  }
  blocks_.resize(blocks);
  table_.resize(static_cast<Eigen::Index>(most), static_cast<Eigen::Index>(most));
  const auto row_in = [](const Front& front, int row) {
    return static_cast<int>(std::lower_bound(front.rows.begin(), front.rows.end(), row) - front.rows.begin());
  };
  std::size_t depth = 0, deepest = 0;
  for (std::size_t f = 0; f < fronts_.size(); ++f) {
    Front& front = fronts_[f];
    for (const int child : front.children) depth -= at(fronts_[at(child)].rest()) * at(fronts_[at(child)].rest());
    depth += at(front.rest()) * at(front.rest());
    deepest = std::max(deepest, depth);
    if (front.rest() == 0) continue;
    Front& parent = fronts_[at(front_of[at(front.rows[at(front.width)])])];
    parent.children.push_back(static_cast<int>(f));
    for (std::size_t i = at(front.width); i < front.rows.size(); ++i) front.places.push_back(row_in(parent, front.rows[i]));
  }
  stack_.resize(deepest);
  diagonal_.resize(at(size_));
  least_.resize(at(size_));
  for (std::size_t e = 0; e < entries.size(); ++e) {
    const int a = order_[at(entries[e].first)], b = order_[at(entries[e].second)];
    if (a == b) diagonal_[at(a)] = static_cast<int>(e);
    Front& front = fronts_[at(front_of[at(std::min(a, b))])];
    front.entries.push_back({static_cast<int>(e), row_in(front, std::max(a, b)) + row_in(front, std::min(a, b)) * static_cast<int>(front.rows.size())});
  }
}

namespace {

// Eliminates the first columns of a table, of which the lower half counts. A pivot is at least `least`.
void eliminate(Table& table, int width, const double* least) {
  const Eigen::Index size = table.rows();
  for (Eigen::Index from = 0; from < width; from += kPanel) {
    const Eigen::Index to = std::min<Eigen::Index>(from + kPanel, width), below = size - to;
    // A narrow table's rest is told at once.
    const Eigen::Index told = below < kPanel ? size : to;
    for (Eigen::Index j = from; j < to; ++j) {
      double* const column = table.data() + j * size;
      const double pivot = std::sqrt(std::max(column[j], least[j])), part = 1 / pivot;
      column[j] = pivot;
      for (Eigen::Index i = j + 1; i < size; ++i) column[i] *= part;
      for (Eigen::Index k = j + 1; k < told; ++k) {
        double* const other = table.data() + k * size;
        const double times = column[k];
        for (Eigen::Index i = k; i < size; ++i) other[i] -= times * column[i];
      }
    }
    if (told < size) table.bottomRightCorner(below, below).selfadjointView<Eigen::Lower>().rankUpdate(table.block(to, from, below, to - from), -1);
  }
}

// Adds what a child left.
void add(Table& table, const double* from, const std::vector<int>& places) {
  const std::size_t rest = places.size();
  for (std::size_t j = 0; j < rest; ++j, from += rest) {
    double* const to = table.data() + at(places[j]) * at(static_cast<int>(table.rows()));
    for (std::size_t i = j; i < rest; ++i) to[places[i]] += from[i];
  }
}

}  // namespace

void Fronts::factor(const std::vector<double>& values) {
  std::size_t top = 0;
  for (std::size_t i = 0; i < at(size_); ++i) least_[i] = kLeastPivot * values[at(diagonal_[i])];
  for (const Front& front : fronts_) {
    const auto size = static_cast<Eigen::Index>(front.rows.size()), rest = size - front.width;
    Table table(table_.data(), size, size);
    table.setZero();
    for (const Entry& entry : front.entries) table.data()[entry.to] = values[at(entry.from)];
    for (auto child = front.children.rbegin(); child != front.children.rend(); ++child) {
      const std::vector<int>& places = fronts_[at(*child)].places;
      top -= places.size() * places.size();
      add(table, stack_.data() + top, places);
    }
    eliminate(table, front.width, least_.data() + front.first);
    Table(blocks_.data() + front.block, size, front.width) = table.leftCols(front.width);
    Table(stack_.data() + top, rest, rest) = table.bottomRightCorner(rest, rest);
    top += front.places.size() * front.places.size();
  }
}

Eigen::VectorXd Fronts::solve(const Eigen::VectorXd& right) const {
  Eigen::VectorXd x(size_);
  for (int i = 0; i < size_; ++i) x[order_[at(i)]] = right[i];
  std::vector<double> sum(at(static_cast<int>(table_.rows())));  // of a front's rows, side by side
  for (const Front& front : fronts_) {
    std::fill_n(sum.begin(), front.rows.size(), 0.0);
    const double* column = blocks_.data() + front.block;
    for (int j = 0; j < front.width; ++j, column += front.rows.size()) {
      double& own = x[front.first + j];
      own = (own - sum[at(j)]) / column[j];
      for (std::size_t i = at(j) + 1; i < front.rows.size(); ++i) sum[i] += column[i] * own;
    }
    for (std::size_t i = at(front.width); i < front.rows.size(); ++i) x[front.rows[i]] -= sum[i];
  }
  for (auto front = fronts_.rbegin(); front != fronts_.rend(); ++front) {
    for (std::size_t i = 0; i < front->rows.size(); ++i) sum[i] = x[front->rows[i]];
    for (int j = front->width - 1; j >= 0; --j) {
      const double* column = blocks_.data() + front->block + front->rows.size() * at(j);
      const auto below = static_cast<Eigen::Index>(front->rows.size()) - j - 1;
      const Eigen::Map<const Eigen::VectorXd> rows(column + j + 1, below), known(sum.data() + j + 1, below);
      x[front->first + j] = sum[at(j)] = (sum[at(j)] - rows.dot(known)) / column[j];
    }
  }
  Eigen::VectorXd left(size_);
  for (int i = 0; i < size_; ++i) left[i] = x[order_[at(i)]];
  return left;
}

}  // namespace tumble::dynamics
