-- The functions and variables of a run, and how a living table takes what changed in the text.
return function(parts)
  local core = parts.core
  local debug = core.debug
  local variables = {}

  -- ---- comparing and copying plain data
  -- A copy that later shows what the value was; functions and objects stand for themselves.
  local function snapshot(value, seen)
    if type(value) ~= "table" then return value end
    seen = seen or {}
    if seen[value] then return seen[value] end
    local copy = {}
    seen[value] = copy
    for key, entry in next, value do copy[key] = snapshot(entry, seen) end
    return copy
  end

  -- Equal content; functions count as equal, since their text is looked after elsewhere.
  local function equal(a, b, seen)
    if type(a) ~= type(b) then return false end
    if type(a) == "function" then return true end
    if type(a) ~= "table" then return core.same(a, b) end
    seen = seen or {}
    if seen[a] == b then return true end
    seen[a] = b
    for key, entry in next, a do
      if not equal(entry, rawget(b, key), seen) then return false end
    end
    for key in next, b do
      if rawget(a, key) == nil then return false end
    end
    return true
  end

  -- ---- collecting: every function by its path, and the variables they use,
  -- of the given files of a run (a file that came late joins those that are there).
  local function collect(run, list)
    local seen_tables = {}
    run.functions = run.functions or {}          -- closure -> path
    run.homes = run.homes or {}                  -- closure -> path of its file
    run.variables = run.variables or {}          -- upvalue id -> variable
    run.variable_list = run.variable_list or {}
    local visit_function, visit_table

    local function variable(file, fn, index, name, path)
      local id = debug.upvalueid(fn, index)
      local found = run.variables[id]
      if not found then
        found = { name = name, file = file.path, fn = fn, index = index, users = {} }
        run.variables[id] = found
        run.variable_list[#run.variable_list + 1] = found
        local _, value = debug.getupvalue(fn, index)
        found.initial = snapshot(value)
        found.declared = value
        if type(value) == "function" then visit_function(file, value, name)
        elseif type(value) == "table" and value ~= file.env then visit_table(file, value, name) end
      end
      found.users[path] = true
    end

    function visit_function(file, fn, path)
      if run.functions[fn] or debug.getinfo(fn, "S").source ~= "@" .. file.path then return end
      run.functions[fn] = path
      run.homes[fn] = file.path
      for index = 1, 255 do
        local name = debug.getupvalue(fn, index)
        if not name then break end
        if name ~= "_ENV" then variable(file, fn, index, name, path) end
      end
    end

    function visit_table(file, t, path)
      if seen_tables[t] then return end
      seen_tables[t] = true
      for _, key in ipairs(core.keys(t)) do
        local entry = rawget(t, key)
        local below = path .. "." .. tostring(key)
        if type(entry) == "function" then visit_function(file, entry, below)
        elseif type(entry) == "table" then visit_table(file, entry, below) end
      end
    end

    local nodes = core.declared_nodes()
    for _, file in ipairs(list) do
      for _, name in ipairs(core.keys(file.declared)) do visit_function(file, file.env[name], name) end
      if type(file.value) == "table" then visit_table(file, file.value, "return") end
      if type(file.value) == "function" then visit_function(file, file.value, "return") end
      for _, node in ipairs(nodes) do
        local slots = run.slots[node]
        for _, name in ipairs(slots and core.keys(slots) or {}) do
          visit_function(file, slots[name], core.node_key(node) .. "." .. name)
        end
      end
      file.initial_value = snapshot(file.value)
    end
  end

  -- ---- pairing and merging
  local function find_old(old, new_variable, taken)
    local best, best_shared = nil, -1
    for _, candidate in ipairs(old.variable_list) do
      if candidate.name == new_variable.name and candidate.file == new_variable.file and not taken[candidate] then
        local shared = 0
        for path in pairs(new_variable.users) do
          if candidate.users[path] then shared = shared + 1 end
        end
        if shared > best_shared then best, best_shared = candidate, shared end
      end
    end
    return best
  end

  local function is_list(t)
    local count = 0
    for _ in next, t do count = count + 1 end
    return count == #t and count > 0
  end

  -- Makes the living table what the new text says where the text changed, in place, so that whoever holds it sees it.
  local function merge(state, live, old, new, path)
    if state.merged[new] or live == new then return end
    state.merged[new] = live
    local function take(key, was)
      local entry = rawget(new, key)
      rawset(live, key, entry)
      if type(entry) ~= "function" and not (was and core.same(was, entry)) then
        state.log[#state.log + 1] = ("%s.%s = %s"):format(path, tostring(key), core.short(entry))
      end
    end
    if (is_list(new) or is_list(old)) and not equal(old, new) then
      local played = not equal(old, live)
      for _, key in ipairs(core.keys(live)) do rawset(live, key, nil) end
      for _, key in ipairs(core.keys(new)) do rawset(live, key, rawget(new, key)) end
      state.log[#state.log + 1] = ("list %s taken whole%s"):format(path, played and "; play had changed it" or "")
      return
    end
    for _, key in ipairs(core.keys(new)) do
      local fresh, was, now = rawget(new, key), old[key], rawget(live, key)
      if type(fresh) == "function" then
        if type(now) ~= "function" or type(was) == "function" then rawset(live, key, fresh) end
      elseif type(fresh) == "table" and type(now) == "table" and type(was) == "table" then
        merge(state, now, was, fresh, path .. "." .. tostring(key))
      elseif not equal(was, fresh) then
        take(key, now)
      end
    end
    for _, key in ipairs(core.keys(old)) do
      if rawget(new, key) == nil and rawget(live, key) ~= nil then
        if type(old[key]) == "function" or equal(old[key], rawget(live, key)) then rawset(live, key, nil) end
      end
    end
  end

  variables.collect, variables.equal, variables.find_old, variables.merge = collect, equal, find_old, merge
  return variables
end
