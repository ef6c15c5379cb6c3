-- expect: require: '../secret' is outside the game
require "../secret"
