#include "base/handle.h"

#include <catch2/catch.hpp>
#include <string>

using namespace tumble;

TEST_CASE("handle: the default one names nothing", "[base]") {
  Pool<std::string> pool;
  pool.add("a");

  CHECK_FALSE(Handle<std::string>{});
  CHECK(pool.get({}) == nullptr);
}

TEST_CASE("handle: one of a removed element names nothing, even when its place is used again", "[base]") {
  Pool<std::string> pool;
  const auto old = pool.add("old");
  pool.remove(old);

  const auto fresh = pool.add("fresh");

  CHECK(fresh.index == old.index);
  CHECK(pool.get(old) == nullptr);
  CHECK(*pool.get(fresh) == "fresh");
}

TEST_CASE("handle: the same calls give the same handles", "[base]") {
  const auto run = [] {
    Pool<int> pool;
    std::vector<Handle<int>> handles;
    for (int i = 0; i < 5; ++i) handles.push_back(pool.add(i));
    pool.remove(handles[3]);
    pool.remove(handles[1]);
    for (int i = 0; i < 4; ++i) handles.push_back(pool.add(i));
    return handles;
  };

  CHECK(run() == run());
}

TEST_CASE("handle: removing twice is harmless", "[base]") {
  Pool<int> pool;
  const auto a = pool.add(1);

  pool.remove(a);
  pool.remove(a);

  CHECK(pool.size() == 0);
  CHECK(pool.add(2) != pool.add(3));
}

TEST_CASE("handle: a reserved one names nothing until its element is placed", "[base]") {
  Pool<int> pool;
  const auto reserved = pool.reserve();

  CHECK(pool.get(reserved) == nullptr);
  CHECK(pool.size() == 0);
  CHECK(pool.add(1) != reserved);
  pool.place(reserved, 2);

  CHECK(*pool.get(reserved) == 2);
  CHECK(pool.size() == 2);
}

TEST_CASE("handle: a reserved one that is given back is given out again with another generation", "[base]") {
  Pool<int> pool;
  const auto reserved = pool.reserve();

  pool.remove(reserved);
  const auto next = pool.add(1);

  CHECK(next.index == reserved.index);
  CHECK(next.generation != reserved.generation);
}

TEST_CASE("handle: a vacated element comes back under its handle", "[base]") {
  Pool<int> pool;
  const auto a = pool.add(1);

  pool.vacate(a);
  CHECK(pool.get(a) == nullptr);
  CHECK(pool.size() == 0);
  CHECK(pool.add(5).index != a.index);
  pool.place(a, 2);

  CHECK(*pool.get(a) == 2);
}

TEST_CASE("handle: an element may be placed where another pool's handle points", "[base]") {
  Pool<int> pool;

  pool.place({3, 7}, 42);

  CHECK(*pool.get({3, 7}) == 42);
  CHECK(pool.get({3, 6}) == nullptr);
  for (int i = 0; i < 4; ++i) CHECK(pool.add(i).index != 3);
}

TEST_CASE("handle: each visits what is there in the order of its index", "[base]") {
  Pool<int> pool;
  const auto a = pool.add(1);
  pool.add(2);
  pool.add(3);
  pool.remove(a);

  std::vector<int> seen;
  pool.each([&](Handle<int>, int& value) { seen.push_back(value); });

  CHECK(seen == std::vector<int>{2, 3});
}
