#include "physics/dynamics/drive.h"

#include <algorithm>
#include <cmath>

#include "physics/dynamics/oscillator.h"

namespace tumble::dynamics {

namespace {

constexpr double kServoRate = 30;   // 1/s: a motor with a target nears it as exp(-30 t)
constexpr double kRepair = 0.2;     // part of what a limit was passed by that one substep takes back
// A limit acts where it may be reached: at so many times the speed that a freedom has now, and at least this near.
constexpr double kAhead = 4, kNear = 0.02;

double servo_speed(const Drive& drive, double h) {
  const MotorDef& motor = *drive.freedom.motor;
  const double error = *motor.target - drive.position;
  double speed = std::abs(error) * std::min(kServoRate, 0.5 / h);
  if (motor.strength) {  // no faster than it can brake with four fifths of its strength
    const double braking = 0.8 * *motor.strength * drive.mobility;
    speed = std::min(speed, std::sqrt(2 * braking * std::abs(error)));
  }
  if (motor.speed) speed = std::min(speed, std::abs(*motor.speed));
  return std::copysign(speed, error);
}

// The way on to where it may be, positive while there is some.
double room(const Drive& drive) {
  return drive.kind == Drive::low ? drive.position - *drive.freedom.min : *drive.freedom.max - drive.position;
}

void bound_limit(Drive& drive, double allowed) {
  drive.lower = drive.kind == Drive::low ? 0 : -INFINITY;
  drive.upper = drive.kind == Drive::low ? INFINITY : 0;
  drive.target = drive.kind == Drive::low ? -allowed : allowed;
}

// As near in this substep as there is room.
void aim_limit_before(Drive& drive, double h) {
  const double left = room(drive);
  drive.aim = left >= 0 ? 0 : (1 - kRepair) * left;
  bound_limit(drive, (left >= 0 ? left : kRepair * left) / h);
}

// What was not reached is the next substep's business.
void aim_limit_after(Drive& drive) {
  bound_limit(drive, 0);
  if (drive.impulse == 0 && room(drive) > 0) drive.lower = drive.upper = 0;
}

void aim_spring(Drive& drive, double speed, double h) {
  const SpringDef& spring = *drive.freedom.spring;
  const double w = 2 * kPi * spring.frequency;
  // What other forces do, they do all the time: they shift the rest.
  const double pull = (speed - drive.before) * 2 / h, rest = spring.rest + pull / (w * w), x = drive.position - rest;
  const Swing end = swung({x, drive.before}, w, spring.damping, h);
  drive.target = (end.position - x) / h;
  drive.target_after = end.velocity;
  // A motor, brake or limit along the same freedom is a steady force more, which shifts the rest too. Of a speed of 1 that
  // it gives in a half, or in both, this much is left.
  const double shift = 2 / (h * w * w);
  drive.yield = (swung({-shift, 0}, w, spring.damping, h).position + shift) / h;
  drive.yield_after = swung({-shift / 2, 0}, w, spring.damping, h).velocity;
}

double motor_speed(const Drive& drive, double h) {
  return drive.freedom.motor->target ? servo_speed(drive, h) : *drive.freedom.motor->speed;
}

}  // namespace

std::vector<Drive> drives_of(Link& link) {
  std::vector<Drive> list;
  for (std::size_t i = 0; i < link.rows.free.size(); ++i) {
    const Freedom& f = link.rows.free[i].freedom;
    const auto add = [&](Drive::Kind kind, double strength) {
      Drive drive;
      drive.kind = kind;
      drive.link = &link;
      drive.free_row = static_cast<int>(i);
      drive.freedom = f;
      drive.strength = strength;
      list.push_back(drive);
    };
    if (f.min && f.max && *f.min == *f.max) continue;  // held
    if (f.spring && f.spring->frequency > 0) add(Drive::spring, INFINITY);
    if (f.friction > 0) add(Drive::brake, f.friction);
    if (f.motor && (f.motor->speed || f.motor->target)) add(Drive::motor, f.motor->strength.value_or(INFINITY));
    if (f.min) add(Drive::low, INFINITY);
    if (f.max) add(Drive::high, INFINITY);
  }
  for (std::size_t i = 0; i < link.rows.held.size(); ++i) {
    if (link.rows.held[i].friction < 0) continue;
    Drive drive;
    drive.link = &link;
    drive.held_row = static_cast<int>(i);
    drive.strength = link.rows.held[i].friction;
    list.push_back(drive);
  }
  return list;
}

void refresh(Drive& drive, double h) {
  if (drive.free_row < 0) {
    drive.row = drive.link->rows.held[static_cast<std::size_t>(drive.held_row)];
    drive.active = true;
    return;
  }
  const auto at = static_cast<std::size_t>(drive.free_row);
  drive.row = drive.link->rows.free[at].row;
  drive.position = drive.link->positions[at];
  const bool limit = drive.kind == Drive::low || drive.kind == Drive::high;
  drive.active = !limit || room(drive) < kNear + kAhead * std::abs(speed(*drive.link, drive.row)) * h;
}

void aim_before(Drive& drive, double speed, double h) {
  switch (drive.kind) {
    case Drive::spring:
      drive.lower = -INFINITY;
      drive.upper = INFINITY;
      aim_spring(drive, speed, h);
      break;
    case Drive::brake:
    case Drive::motor:
      drive.upper = drive.strength * h / 2;
      drive.lower = -drive.upper;
      drive.target = drive.kind == Drive::motor ? motor_speed(drive, h) : 0;
      break;
    case Drive::low:
    case Drive::high: aim_limit_before(drive, h); break;
  }
}

void aim_after(Drive& drive, double h) {
  switch (drive.kind) {
    case Drive::spring:
      drive.target = drive.target_after;
      drive.yield = drive.yield_after;
      break;
    case Drive::brake:
    case Drive::motor:
      drive.upper = drive.strength * h;
      drive.lower = -drive.upper;
      drive.target = drive.kind == Drive::motor ? motor_speed(drive, h) : 0;
      break;
    case Drive::low:
    case Drive::high: aim_limit_after(drive); break;
  }
}

double passed(const Drive& drive) {
  if (!drive.active || (drive.kind != Drive::low && drive.kind != Drive::high)) return 0;
  Drive now = drive;
  now.position = drive.link->positions[static_cast<std::size_t>(drive.free_row)];
  return std::max(0.0, drive.aim - room(now));
}

}  // namespace tumble::dynamics
