-- expect: no event 'on_pres'; did you mean 'on_press'?
function on_pres(name) end
