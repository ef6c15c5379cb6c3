// A program with a Lua and a Bullet of its own, other ones than Tumble's: C and float. Both work while games run in the
// same process. Prints what is wrong; status 0 where nothing is.
#include <tumble/tumble.h>

#include <btBulletDynamicsCommon.h>
#include <lua.hpp>

#include <cmath>
#include <iostream>
#include <string>

namespace {

int wrong = 0;

void check(bool holds, const std::string& claim) {
  if (holds) return;
  std::cout << "not so: " << claim << '\n';
  ++wrong;
}

// ---- the host's own engines

static_assert(sizeof(btScalar) == 4, "the host's Bullet is the float one");

// Drops a ball from 10 m; its height after some ticks.
double height_in_own_bullet(int ticks) {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity(btVector3(0, -9.81f, 0));
  btSphereShape shape(0.5f);
  btDefaultMotionState state(btTransform(btQuaternion::getIdentity(), btVector3(0, 10, 0)));
  btRigidBody body(btRigidBody::btRigidBodyConstructionInfo(2, &state, &shape, btVector3(1, 1, 1)));
  world.addRigidBody(&body);
  for (int i = 0; i < ticks; ++i) world.stepSimulation(1 / 60.f, 0);
  const double height = body.getWorldTransform().getOrigin().y();
  world.removeRigidBody(&body);
  return height;
}

class OwnLua {
 public:
  OwnLua() : L_(luaL_newstate()) { luaL_openlibs(L_); }
  ~OwnLua() { lua_close(L_); }
  // What the chunk returns, as text; its error where it fails.
  std::string run(const std::string& text) {
    if (luaL_dostring(L_, text.c_str()) != LUA_OK || lua_gettop(L_) == 0) lua_settop(L_, 1);
    const char* result = lua_tostring(L_, 1);
    const std::string answer = result ? result : "";
    lua_settop(L_, 0);
    return answer;
  }

 private:
  lua_State* L_;
};

// ---- games

struct Heard {
  int wind_calls = 0, errors = 0;
  std::string last_error;
};

void prepare(tumble::Runtime& runtime, Heard& heard, OwnLua& lua) {
  runtime.add_function("wind", "Force of the wind at a height, N.", {"height"}, [&heard, &lua](double height) {
    ++heard.wind_calls;
    // The host's Lua computes inside a call from Tumble's, and an error in it stays its own.
    if (lua.run("error('mine')").find("mine") == std::string::npos) ++wrong;
    return std::stod(lua.run("return " + std::to_string(height) + " > 5 and 3 or 0"));
  });
  runtime.add_function("refuse", "Always fails.", {}, []() -> double { throw tumble::Error("host.refuse: no"); });
  runtime.on_script_error([&heard](const tumble::ScriptError& error) {
    ++heard.errors;
    heard.last_error = error.text;
  });
}

void play(const std::string& game) {
  OwnLua lua;
  Heard heard, other_heard;
  tumble::Runtime runtime, other;
  prepare(runtime, heard, lua);
  prepare(other, other_heard, lua);
  runtime.load(game);
  other.load(game);

  runtime.tick(60);
  const tumble::Node ball = runtime.node("ball");
  const double fallen = 10 - 0.5 * 9.81;
  check(std::abs(ball.position().y - fallen) < 0.1, "the ball fell for a second: " + std::to_string(ball.position().y));
  check(std::abs(height_in_own_bullet(60) - ball.position().y) < 0.1, "both engines agree on the fall");
  check(ball.velocity().x > 1 && ball.position().x > 0.5, "the host's wind blew it aside");
  check(heard.wind_calls == 60, "the wind was asked for every tick: " + std::to_string(heard.wind_calls));
  check(other.tick_number() == 0 && std::abs(other.node("ball").position().y - 10) < 1e-9, "the other game stood still");

  other.tick(60);
  check(runtime.hash() == other.hash(), "equal games come to equal worlds");

  runtime.tick(120);
  check(ball.get("behaviours.ball.touched").number_or(0) >= 1, "a behaviour's field can be read");
  check(ball.get("body.mass").number_or(0) == 2, "a component's field can be read");
  runtime.press("space");
  runtime.tick(10);
  check(ball.velocity().y > 5, "input reaches the game");
  runtime.send("greet", {"hello", tumble::Vec3{1, 2, 3}});
  runtime.tick();
  check(runtime.report("greeting").string_or("").find("hello from ") == 0, "messages reach the game");

  check(heard.errors == 0, "no script error so far: " + heard.last_error);
  runtime.send("ask");
  runtime.tick();
  check(runtime.report("refused").string_or("").find("host.refuse: no") != std::string::npos, "an error of the host's function is the script's to catch");
  check(heard.errors == 1 && heard.last_error.find("mass") != std::string::npos, "a script's error is told: " + heard.last_error);
  check(lua.run("return _VERSION .. ' ' .. tostring(vec3)") == "Lua 5.4 nil", "the host's Lua has nothing of the game");

  try {
    runtime.node("bal");
    check(false, "a name that is not there is an Error");
  } catch (const tumble::Error& error) {
    check(std::string(error.what()).find("ball") != std::string::npos, std::string("the Error names the nearest: ") + error.what());
  }
}

}  // namespace

int main(int, char** argv) {
  try {
    play(argv[1]);
  } catch (const std::exception& error) {
    check(false, error.what());
  }
  std::cout << (wrong ? "FAILED" : "ok") << " embed: a host and its games live together\n";
  return wrong ? 1 : 0;
}
