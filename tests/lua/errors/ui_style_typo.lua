-- expect: ui.style: no field 'acent'; did you mean 'accent'?
ui.style { acent = "gold" }
