-- expect: string has no 'dump'
string.dump(function() end)
