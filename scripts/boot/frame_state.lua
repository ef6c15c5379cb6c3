-- What frame() must leave as it is. It runs as often as pictures are drawn, so nothing that it writes may reach a tick. The
-- engine refuses its own calls there; locals of files, fields of behaviours and entries of the tables behind them are put back
-- here, with a sentence. Games without frame() pay nothing; in others tables beyond the limit below are not looked at.
return function(parts)
  local files, records, debug = parts.files, parts.behaviours.records, parts.core.debug
  local frame_state = {}

  local most_entries = 20000
  local function take_table(state, t)
    if state.tables[t] or state.entries > most_entries or getmetatable(t) == "environment" then return end
    local copy = {}
    state.tables[t] = copy
    state.metatables[t] = debug.getmetatable(t)
    for key, value in next, t do
      copy[key] = value
      state.entries = state.entries + 1
      if type(value) == "table" then take_table(state, value) end
    end
  end

  -- Of all files and of the tables in `subjects`.
  function frame_state.take(subjects)
    local state = { locals = {}, tables = {}, metatables = {}, entries = 0 }
    for i, variable in ipairs(files.live.variable_list) do
      local _, value = debug.getupvalue(variable.fn, variable.index)
      state.locals[i] = value
      if type(value) == "table" then take_table(state, value) end
    end
    for _, subject in ipairs(subjects) do
      if subject then take_table(state, subject) end
    end
    return state
  end

  local function restore_table(t, copy)
    local changed
    for key, value in next, t do
      if not rawequal(value, copy[key]) then changed = key end
    end
    for key, value in next, copy do
      if not rawequal(value, rawget(t, key)) then changed = key end
    end
    if changed == nil then return nil end
    local extra = {}
    for key in next, t do if copy[key] == nil then extra[#extra + 1] = key end end
    for _, key in ipairs(extra) do rawset(t, key, nil) end
    for key, value in next, copy do rawset(t, key, value) end
    return tostring(changed)
  end

  -- Puts it back; tells the first thing that had changed, or nil.
  function frame_state.restore(state)
    local changed
    for i, variable in ipairs(files.live.variable_list) do
      local _, value = debug.getupvalue(variable.fn, variable.index)
      if not rawequal(value, state.locals[i]) then
        debug.setupvalue(variable.fn, variable.index, state.locals[i])
        changed = changed or ("%s: frame changed the local '%s'"):format(variable.file, variable.name)
      end
    end
    for t, copy in next, state.tables do
      if debug.getmetatable(t) ~= state.metatables[t] then
        debug.setmetatable(t, state.metatables[t])
        changed = changed or "frame changed a metatable"
      end
      local key = restore_table(t, copy)
      local record = records[t]
      if key and record then
        changed = changed or ("%s: frame changed the field '%s'"):format(record.info.file.path, key)
      elseif key then
        changed = changed or ("frame changed the entry '%s' of a table"):format(key)
      end
    end
    return changed
  end

  return frame_state
end
