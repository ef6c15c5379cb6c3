-- Tasks and tweens: what happens later, and what goes on for a while. Time is the game's, so pauses hold them.
return function(parts)
  local core = parts.core
  local tasks = {}
  local list = {}                    -- all that are under way, oldest first
  local waiting = setmetatable({}, { __mode = "k" })   -- coroutine -> its task
  tasks.owner = nil                  -- the behaviour whose handler runs now

  -- What a script holds of a task; the task itself stays here.
  local handles = setmetatable({}, { __mode = "k" })   -- handle -> task
  local methods = {}
  local meta = {
    __index = function(handle, name)
      if name == "is_done" then return handles[handle].done == true end
      if methods[name] then return methods[name] end
      core.raise(("task has no '%s'; it has stop(), wait(), and_then() and is_done"):format(tostring(name)))
    end,
    __newindex = function() core.raise("a task cannot be written; it has stop(), wait(), and_then() and is_done") end,
    __metatable = "task",
    __name = "task",
  }

  local function add(task)
    task.owner = tasks.owner
    list[#list + 1] = task
    local handle = setmetatable({}, meta)
    handles[handle] = task
    return handle
  end

  local function seconds_or_fail(call, seconds)
    if type(seconds) ~= "number" or seconds ~= seconds or seconds < 0 or seconds == math.huge then
      core.raise(("%s: seconds: a number of 0 or more expected, got %s"):format(call, core.short(seconds)))
    end
    return seconds
  end
  local function function_or_fail(call, fn)
    if type(fn) ~= "function" then
      core.raise(("%s: fn: function expected, got %s%s"):format(call, core.short(fn),
        fn == nil and "; pass the function itself, without ()" or ""))
    end
    return fn
  end

  local function task_of(handle, call)
    return handles[handle] or core.raise(("task:%s: task expected before the colon; was it called with a dot?"):format(call))
  end
  function methods.stop(handle) task_of(handle, "stop").done = true end
  function methods.wait(handle)
    local task = task_of(handle, "wait")
    local own = waiting[coroutine.running()]
    if not own then core.raise("task:wait: works only in a task; write task.spawn(function() other:wait() ... end)") end
    while not task.done do core.yield(0) end
  end
  function methods.and_then(handle, fn, ...)
    local task = task_of(handle, "and_then")
    task.next_fn = function_or_fail("and_then", fn)
    task.next_args = table.pack(...)
    return handle
  end

  tasks.task = {
    after = function(seconds, fn, ...)
      core.permit_act("task.after")
      return add { due = core.now() + seconds_or_fail("task.after", seconds), fn = function_or_fail("task.after", fn), args = table.pack(...) }
    end,
    every = function(seconds, fn, ...)
      core.permit_act("task.every")
      seconds = seconds_or_fail("task.every", seconds)
      if seconds == 0 then core.raise("task.every: seconds must be above 0 (got 0)") end
      return add { due = core.now() + seconds, every = seconds, fn = function_or_fail("task.every", fn), args = table.pack(...) }
    end,
    spawn = function(fn, ...)
      core.permit_act("task.spawn")
      return add { due = core.now(), spawn = true, fn = function_or_fail("task.spawn", fn), args = table.pack(...) }
    end,
    loop = function(fn, ...)
      core.permit_act("task.loop")
      return add { due = core.now(), spawn = true, loop = true, fn = function_or_fail("task.loop", fn), args = table.pack(...) }
    end,
  }

  core.globals.wait = function(seconds)
    seconds_or_fail("wait", seconds)
    local own = waiting[coroutine.running()]
    if not own then core.raise("wait: works only in a task; write task.spawn(function() wait(1) ... end)") end
    core.yield(seconds)
  end

  core.globals.wait_until = function(condition, timeout)
    function_or_fail("wait_until", condition)
    local own = waiting[coroutine.running()]
    if not own then core.raise("wait_until: works only in a task; write task.spawn(function() wait_until(...) ... end)") end
    local last = timeout and own.clock() + seconds_or_fail("wait_until", timeout) or math.huge
    while not condition() do
      if own.clock() >= last then return false end
      core.yield(0)
    end
    return true
  end

  -- ---- running them
  -- Resumes a coroutine until it waits. Waits of a bot count ticks, those of a game its time: `clock` tells.
  function tasks.resume(task, clock)
    local co = task.co
    task.clock = clock
    waiting[co] = task
    local ok, wait_or_error = core.resume(co, table.unpack(task.args or {}, 1, task.args and task.args.n or 0))
    task.args = nil
    if not ok then
      core.report_coroutine(wait_or_error, co)
      return false
    end
    if core.status(co) == "dead" then return false end
    -- A hair less than the tick's end, so that wait(1) of sixty ticks does not take sixty-one by rounding.
    task.due = clock() + (wait_or_error or 0) - 1e-9
    return true
  end

  local function run(task)
    tasks.owner = task.owner
    local again = false
    if task.spawn then
      if not task.co then
        task.co = core.coroutine(task.fn)
        task.first_args = task.first_args or task.args
        task.args = task.first_args
        task.started = core.tick()
      end
      again = tasks.resume(task, core.now)
      if not again and task.loop and not task.done then
        if task.started == core.tick() then
          core.report("task.loop: the function ended without waiting; put wait(...) in it", "")
        else
          task.co = nil
          task.due = core.now()
          again = true
        end
      end
    else
      local ok = core.protected(task.fn, table.unpack(task.args, 1, task.args.n))
      if task.every and ok then
        task.due = task.due + task.every
        again = true
      end
    end
    tasks.owner = nil
    if not again then
      task.done = true
      if task.next_fn then core.protected(task.next_fn, table.unpack(task.next_args, 1, task.next_args.n)) end
    end
  end

  local function held(task)
    local owner = task.owner
    return owner and (not owner.enabled or not core.node_enabled(owner.node))
  end

  function tasks.run()
    local now = core.now() + 1e-9
    local count = #list              -- what these add runs from the next tick on
    for i = 1, count do
      local task = list[i]
      if not task.done and held(task) then
        task.due = task.due + core.tick_seconds()
      elseif not task.done and task.due <= now then
        if task.tween then task.tween(task) else run(task) end
      end
    end
    local kept = {}
    for _, task in ipairs(list) do
      if not task.done then kept[#kept + 1] = task end
    end
    list = kept
  end

  function tasks.stop_owned(owner)
    for _, task in ipairs(list) do
      if task.owner == owner then task.done = true end
    end
  end

  -- Tasks made of functions that have a new text call the new ones.
  function tasks.sweep(replaced)
    for _, task in ipairs(list) do
      if replaced[task.fn] then task.fn = replaced[task.fn] end
      if task.next_fn and replaced[task.next_fn] then task.next_fn = replaced[task.next_fn] end
    end
  end

  -- ---- tweens
  local eases = {
    linear = function(t) return t end,
    ["in"] = function(t) return t * t end,
    out = function(t) return 1 - (1 - t) * (1 - t) end,
    in_out = function(t) return t < 0.5 and 2 * t * t or 1 - 2 * (1 - t) * (1 - t) end,
    out_back = function(t) local u = t - 1 return 1 + 2.70158 * u * u * u + 1.70158 * u * u end,
    out_bounce = function(t)
      if t < 1 / 2.75 then return 7.5625 * t * t end
      if t < 2 / 2.75 then t = t - 1.5 / 2.75 return 7.5625 * t * t + 0.75 end
      if t < 2.5 / 2.75 then t = t - 2.25 / 2.75 return 7.5625 * t * t + 0.9375 end
      t = t - 2.625 / 2.75
      return 7.5625 * t * t + 0.984375
    end,
  }
  local ease_names = { "linear", "in", "out", "in_out", "out_back", "out_bounce" }

  local function between(from, to, t)
    local kind = core.kind(from)
    if kind == "number" then return from + (to - from) * t end
    if kind == "quat" then return from:slerp(to, t) end
    return from:lerp(to, t)
  end

  local function goal(from, to, name)
    local kind, given = core.kind(from), to
    if kind == "color" then to = core.as_color(to) elseif kind == "vec3" then to = core.as_vec3(to) end
    if kind ~= "number" and kind ~= "vec3" and kind ~= "quat" and kind ~= "color" then
      core.raise(("tween: field '%s' holds %s; only numbers, vec3, quat and color can be tweened"):format(name, core.short(from)))
    end
    if core.kind(to) ~= kind then core.raise(("tween: field '%s': %s expected, got %s"):format(name, kind, core.short(given))) end
    return to
  end

  core.globals.tween = function(target, seconds, goals, options)
    core.permit_act("tween")
    seconds_or_fail("tween", seconds)
    options = options or {}
    if type(goals) ~= "table" or type(options) ~= "table" then
      core.raise(("tween: goals and options: tables expected, got %s and %s; write tween(node, 1, { position = p }, { ease = \"out\" })")
        :format(core.short(goals), core.short(options)))
    end
    local ease = eases[options.ease or "linear"]
    if not ease then
      local near = core.nearest(tostring(options.ease), ease_names)
      core.raise(("tween: unknown ease '%s'%s"):format(tostring(options.ease), near and ("; did you mean '%s'?"):format(near) or ""))
    end
    local fields = {}
    for name, to in core.pairs(goals) do
      local from = target[name]
      fields[#fields + 1] = { name = name, from = from, to = goal(from, to, name) }
      for _, other in ipairs(list) do   -- a new tween of a field takes over from the old one
        if other.tween and other.target == target then
          for i = #other.fields, 1, -1 do
            if other.fields[i].name == name then table.remove(other.fields, i) end
          end
        end
      end
    end
    local begun, rounds, times = core.now() + (options.delay or 0), 0, options.times or 1
    local back = options.back
    return add { due = begun, target = target, fields = fields, tween = function(task)
      local record = parts.behaviours.records[target]
      if core.is_gone(target) or record and not record.alive then task.done = true return end
      local t = seconds > 0 and (core.now() - begun) / seconds or 1
      local span = back and 2 or 1
      local ended = t >= span
      local at = ended and (back and 0 or 1) or (t > 1 and 2 - t or t)
      local ok = core.protected(function()
        for _, field in ipairs(fields) do target[field.name] = between(field.from, field.to, ease(at)) end
      end)
      if not ok then task.done = true return end
      if ended then
        rounds = rounds + 1
        begun = begun + seconds * span
        if rounds >= times then
          task.done = true
          if task.next_fn then core.protected(task.next_fn, table.unpack(task.next_args, 1, task.next_args.n)) end
        end
      end
    end }
  end

  return tasks
end
