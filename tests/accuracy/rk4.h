// One step of the classic Runge-Kutta method (Kutta 1901): the suite's own integrator, for references of kind R.
#pragma once

#include <array>
#include <cstddef>

namespace tumble::accuracy {

// `rates` gives the time derivative of a state.
template <std::size_t N, class Rates>
std::array<double, N> rk4(const std::array<double, N>& state, double h, const Rates& rates) {
  using State = std::array<double, N>;
  const auto moved = [&state](const State& rate, double time) {
    State out = state;
    for (std::size_t i = 0; i < N; ++i) out[i] += rate[i] * time;
    return out;
  };
  const State k1 = rates(state), k2 = rates(moved(k1, h / 2)), k3 = rates(moved(k2, h / 2)), k4 = rates(moved(k3, h));
  State out = state;
  for (std::size_t i = 0; i < N; ++i) out[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
  return out;
}

}  // namespace tumble::accuracy
