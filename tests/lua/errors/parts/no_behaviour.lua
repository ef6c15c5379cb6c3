-- A file that is no behaviour.
return { speed = 2 }
