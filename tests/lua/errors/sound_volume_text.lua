-- expect: sound.volume: number expected, got "loud"
sound.volume = "loud"
