-- The game that the suites in tests/ play with: it writes down what it is told.
local record = require "record"

scene.add { name = "floor", position = vec3(0, -0.5, 0), mesh = { shape = "box", size = vec3(20, 1, 20) }, body = "static" }

function start() table.insert(record.lines, "main start") end

function update(dt)
  record.ticks = record.ticks + 1
  record.dt = dt
  if record.log_ticks then table.insert(record.lines, "main update") end
end

function late_update(dt)
  if record.log_ticks then table.insert(record.lines, "main late_update") end
end

function on_press(name) table.insert(record.presses, "press " .. name) end
function on_release(name) table.insert(record.presses, "release " .. name) end
function on_pointer_move(dx, dy) record.moved_x, record.moved_y = dx, dy end
function on_text(text) record.text = text end
function on_greet(word, number) table.insert(record.lines, ("main %s %d"):format(word, number)) end
