-- Bots and tests: they press keys and point, through the same input that a person uses, and count ticks.
return function(parts)
  local core, files, tasks, boot = parts.core, parts.files, parts.tasks, parts.boot
  local bot = {}
  local player                       -- the running task
  local pointer_x, pointer_y = 640, 360
  local held = {}                    -- keys to let go: { name, at } in ticks
  local slides = {}                  -- pointer motions under way

  local function clock() return core.bot_ticks() * core.tick_seconds() end

  local function check(call, name)
    if type(name) ~= "string" then core.raise(call .. ": a key's or action's name expected, got " .. core.short(name)) end
    return core.raw_name(call, name)
  end

  local verbs = {}
  function verbs.press(name) core.bot_event("press", check("press", name), 0, 0) end
  function verbs.release(name) core.bot_event("release", check("release", name), 0, 0) end
  function verbs.tap(name, seconds)
    name = check("tap", name)
    core.bot_event("press", name, 0, 0)
    held[#held + 1] = { name = name, at = clock() + (seconds or core.tick_seconds()) - 1e-9 }
  end
  function verbs.set_axis(low, high, value)
    if type(value) ~= "number" or value ~= value then core.raise("set_axis: value: a number from -1 to 1 expected, got " .. core.short(value)) end
    low, high = check("set_axis", low), check("set_axis", high)
    core.bot_event("value", low, math.max(0, math.min(1, -value)), 0)
    core.bot_event("value", high, math.max(0, math.min(1, value)), 0)
  end
  function verbs.type_text(text)
    if type(text) ~= "string" or not utf8.len(text) then core.raise("type_text: a text in UTF-8 expected, got " .. core.short(text)) end
    core.bot_event("text", text, 0, 0)
  end
  function verbs.point_at(x, y, seconds)
    if type(x) ~= "number" then
      local place = core.kind(x) == "node" and x.world_position or core.as_vec3(x)
      if not place then core.raise("point_at: x, y or a node or vec3 expected, got " .. core.short(x)) end
      seconds = y
      x, y = core.globals.scene.camera.camera:to_screen(place)
    end
    if not seconds or seconds <= 0 then
      pointer_x, pointer_y = x, y
      core.bot_event("pointer_move", "", x, y)
    else
      slides = { { from_x = pointer_x, from_y = pointer_y, to_x = x, to_y = y, begun = clock(), seconds = seconds } }
      if player and coroutine.isyieldable() then core.yield(seconds) end
    end
  end
  function verbs.turn_wheel(steps)
    if type(steps) ~= "number" then core.raise("turn_wheel: steps: a number expected, got " .. core.short(steps)) end
    core.bot_event("wheel", "", steps, 0)
  end

  -- ---- the ui: what the pointer can do, by the label or id of a widget
  local function check_label(call, label)
    if type(label) ~= "string" then core.raise(call .. ": the label or id of a widget expected, got " .. core.short(label)) end
  end
  function verbs.is_on_screen(label)
    check_label("is_on_screen", label)
    return core.ui_is_on_screen(label)
  end
  -- Waits for the widget, since a menu is on the screen one tick after what opened it; returns when it was let go.
  local longest_wait = 1             -- s
  function verbs.click(label)
    check_label("click", label)
    local can_wait = player and coroutine.isyieldable()
    local begun = clock()
    local x, y = core.ui_place(label)
    while not x and can_wait and clock() < begun + longest_wait do
      core.yield(core.tick_seconds())
      x, y = core.ui_place(label)
    end
    if not x then
      core.raise(("click: no widget '%s' on the screen%s"):format(label, y == "" and "; there is none at all" or "; there are: " .. y))
    end
    verbs.point_at(x, y)
    verbs.tap("pointer")
    if can_wait then core.yield(2 * core.tick_seconds()) end
  end
  verbs.wait, verbs.wait_until = core.globals.wait, core.globals.wait_until

  local function run_held()
    local kept = {}
    for _, key in ipairs(held) do
      if clock() >= key.at then core.bot_event("release", key.name, 0, 0) else kept[#kept + 1] = key end
    end
    held = kept
    for i = #slides, 1, -1 do
      local slide = slides[i]
      local t = math.min(1, (clock() - slide.begun) / slide.seconds)
      pointer_x = slide.from_x + (slide.to_x - slide.from_x) * t
      pointer_y = slide.from_y + (slide.to_y - slide.from_y) * t
      core.bot_event("pointer_move", "", pointer_x, pointer_y)
      if t >= 1 then table.remove(slides, i) end
    end
  end

  -- One tick of the bot, before input is sampled.
  function boot.bot()
    run_held()
    if not player or (player.due and player.due > clock()) then return end
    local outer = tasks.owner
    tasks.owner = nil
    if not tasks.resume(player, clock) then player = nil end
    tasks.owner = outer
  end

  -- ---- the files that get these verbs
  local function environment(extra)
    local env = setmetatable({}, {
      __index = function(_, name)
        local value = verbs[name]
        if value == nil then value = extra and extra[name] end
        if value == nil then value = core.globals[name] end
        if value == nil then core.raise(("unknown name '%s'"):format(tostring(name))) end
        return value
      end,
      __metatable = "environment",
    })
    return env
  end

  local function run_text(path, extra)
    local text = core.read(path)
    if not text then error(path .. ": no such file", 0) end
    local env = environment(extra)
    rawset(env, "require", function(name)
      local run = files.live
      local file = run.modules[name .. ".lua"] or run.modules["std/" .. name .. ".lua"]
      if file then return file.value end
      return parts.reload.load_late(name).value
    end)
    local chunk, message = core.compile(text, path, env)
    if not chunk then error(message, 0) end
    return chunk()
  end

  function boot.load_bot()
    local fn = run_text("bot.lua")
    if type(fn) ~= "function" then error("bot.lua must return a function; end it with `return function() ... end`", 0) end
    player = { co = core.coroutine(fn), args = { n = 0 } }
  end

  -- ---- tests
  local function expectation(value)
    local function fail(text) error(text, 3) end
    local is = {}
    function is:equals(other)
      if not core.same(value, other) and value ~= other then fail(("expected %s, got %s"):format(core.short(other), core.short(value))) end
    end
    function is:near(other, tolerance)
      local distance = core.kind(value) == "vec3" and value:distance(other) or math.abs(value - other)
      if not (distance <= tolerance) then
        fail(("expected %s within %s, got %s (%s away)"):format(core.short(other), core.short(tolerance), core.short(value), core.short(distance)))
      end
    end
    function is:above(other) if not (value > other) then fail(("expected above %s, got %s"):format(core.short(other), core.short(value))) end end
    function is:below(other) if not (value < other) then fail(("expected below %s, got %s"):format(core.short(other), core.short(value))) end end
    function is:contains(part)
      if type(value) == "string" then
        if not value:find(part, 1, true) then fail(("expected a text with %s, got %s"):format(core.short(part), core.short(value))) end
        return
      end
      for _, entry in core.pairs(value) do if entry == part then return end end
      fail(("expected a list with %s"):format(core.short(part)))
    end
    function is:raises(text)
      local ok, message = pcall(value)
      if ok then fail(("expected an error with %s, and there was none"):format(core.short(text))) end
      if not tostring(message):find(text, 1, true) then fail(("expected an error with %s, got %s"):format(core.short(text), core.short(tostring(message)))) end
    end
    return setmetatable(is, { __index = function(_, name) error(("expect has no '%s'; it has equals, near, above, below, contains, raises"):format(tostring(name)), 2) end })
  end

  local tests = {}
  -- The claims in a test file, in their order.
  function boot.list_tests(path)
    tests = {}
    run_text(path, {
      expect = expectation,
      test = function(claim, fn) tests[#tests + 1] = { claim = claim, fn = fn } end,
    })
    local claims = {}
    for i, test in ipairs(tests) do claims[i] = test.claim end
    return claims
  end
  -- Runs one of them as the player; core.test_done says how it went.
  function boot.start_test(number)
    local fn = tests[number].fn
    player = { args = { n = 0 }, co = core.coroutine(function()
      local ok, message = xpcall(fn, core.traceback)
      core.test_done(ok, ok and "" or tostring(message))
    end) }
  end

  return bot
end
