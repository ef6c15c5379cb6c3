-- expect: require: '/etc/passwd' is outside the game
require "/etc/passwd"
