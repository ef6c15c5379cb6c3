-- What happened, in order: handlers write into it, tests read it.
return { lines = {}, presses = {}, ticks = 0 }
