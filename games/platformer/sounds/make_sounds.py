#!/usr/bin/env python3
"""Makes every sound of Little Heights anew from sums of sines and noise: python3 make_sounds.py. Needs ffmpeg (for OGG)."""
import array
import math
import os
import random
import subprocess
import wave

RATE = 32000
HERE = os.path.dirname(os.path.abspath(__file__))


def tone(pitch, seconds, harmonics=((1, 1.0),), decay=6.0, attack=0.004, glide=1.0):
    """A plucked note: `harmonics` are (multiple, loudness); the pitch, Hz, ends at `glide` times what it began with."""
    count = int(seconds * RATE)
    out = [0.0] * count
    for multiple, loudness in harmonics:
        phase = 0.0
        for i in range(count):
            t = i / RATE
            phase += 2 * math.pi * pitch * multiple * glide ** (t / seconds) / RATE
            out[i] += loudness * math.sin(phase) * math.exp(-decay * (0.6 + 0.4 * multiple) * t) * min(1, t / attack)
    return fade(out)


def noise(seconds, decay=20.0, low=0.0, high=1.0, attack=0.002, seed=1):
    """Noise between two edges, 0 to 1: the higher, the brighter."""
    rnd = random.Random(seed)
    smooth = rumble = 0.0
    out = []
    for i in range(int(seconds * RATE)):
        t = i / RATE
        smooth += high * (rnd.uniform(-1, 1) - smooth)
        rumble += low * (smooth - rumble)
        out.append((smooth - rumble) * math.exp(-decay * t) * min(1, t / attack))
    return fade(out)


def fade(sound, seconds=0.01):
    count = min(len(sound), int(seconds * RATE))
    for i in range(count):
        sound[-1 - i] *= i / count
    return sound


def mix(*parts):
    """Parts are (start in seconds, loudness, sound)."""
    out = [0.0] * max(int(start * RATE) + len(sound) for start, _, sound in parts)
    for start, loudness, sound in parts:
        first = int(start * RATE)
        for i, value in enumerate(sound):
            out[first + i] += loudness * value
    return out


def save(name, sound, peak=0.8, quality=3):
    loudest = max(abs(value) for value in sound)
    samples = array.array("h", (int(32767 * peak * value / loudest) for value in sound))
    path = os.path.join(HERE, name)
    with wave.open(path + ".wav", "wb") as file:
        file.setnchannels(1)
        file.setsampwidth(2)
        file.setframerate(RATE)
        file.writeframes(samples.tobytes())
    subprocess.run(["ffmpeg", "-loglevel", "error", "-y", "-i", path + ".wav", "-map_metadata", "-1", "-fflags", "+bitexact",
                    "-flags:a", "+bitexact", "-c:a", "libvorbis", "-q:a", str(quality), path + ".ogg"], check=True)
    os.remove(path + ".wav")


# ---- effects

BELL = ((1, 1.0), (2, 0.5), (3.01, 0.25), (4.2, 0.12))
WOOD = ((1, 1.0), (2.76, 0.4), (5.4, 0.15))


def note(name):
    """Hz of "c4", "f#5" and the like."""
    steps = {"c": 0, "d": 2, "e": 4, "f": 5, "g": 7, "a": 9, "b": 11}
    step = steps[name[0]] + (1 if "#" in name else 0)
    return 440 * 2 ** ((step + 12 * (int(name[-1]) - 4) - 9) / 12)


def arpeggio(names, gap, seconds, harmonics=BELL, decay=5.0):
    return mix(*[(i * gap, 1, tone(note(n), seconds, harmonics, decay)) for i, n in enumerate(names)])


def effects():
    save("jump", tone(300, 0.16, ((1, 1), (2, 0.3)), 9, glide=2.1), 0.5)
    save("land", mix((0, 1, tone(120, 0.14, ((1, 1),), 24, glide=0.5)), (0, 0.5, noise(0.1, 40, 0.02, 0.25))), 0.6)
    save("step", mix((0, 1, noise(0.06, 70, 0.05, 0.3)), (0, 0.5, tone(160, 0.05, ((1, 1),), 60, glide=0.6))), 0.35)
    save("coin", mix((0, 0.7, tone(note("b5"), 0.12, BELL, 10)), (0.07, 1, tone(note("e6"), 0.45, BELL, 7))), 0.5)
    save("gem", arpeggio(["e5", "g#5", "b5", "e6", "g#6"], 0.06, 0.6), 0.55)
    save("checkpoint", arpeggio(["g4", "c5", "e5", "g5"], 0.09, 0.7), 0.6)
    save("goal", mix((0, 1, arpeggio(["c5", "e5", "g5", "c6", "g5", "c6"], 0.13, 0.6)),
                     (0.78, 0.8, arpeggio(["c4", "e5", "g5", "c6", "e6"], 0.0, 1.6, decay=2.5))), 0.7)
    save("hurt", mix((0, 1, tone(330, 0.35, ((1, 1), (2, 0.5), (3, 0.4)), 5, glide=0.4)), (0, 0.4, noise(0.2, 15, 0.05, 0.4))), 0.55)
    save("bounce", tone(170, 0.4, ((1, 1), (2, 0.4), (3, 0.15)), 5, glide=2.6), 0.6)
    save("lever", mix((0, 1, noise(0.05, 60, 0.1, 0.6)), (0.12, 1, tone(210, 0.15, WOOD, 20)), (0.12, 0.6, noise(0.04, 90, 0.1, 0.8))), 0.6)
    creak = [(0.07 * i + 0.02 * math.sin(i * 5), 0.5 + 0.3 * math.sin(i * 3), tone(150 + 14 * math.sin(i * 2.1), 0.09, WOOD, 18)) for i in range(11)]
    save("door", mix(*creak, (0.85, 1.6, tone(90, 0.25, WOOD, 14)), (0.85, 0.6, noise(0.08, 40, 0.02, 0.3))), 0.6)
    save("plate", mix((0, 1, tone(240, 0.1, WOOD, 25, glide=0.7)), (0.06, 0.7, tone(320, 0.12, WOOD, 22))), 0.55)
    save("crate", scrape(), 0.4)
    save("thud", mix((0, 1, tone(95, 0.2, WOOD, 18, glide=0.7)), (0, 0.5, noise(0.08, 50, 0.03, 0.35))), 0.6)
    save("click", tone(820, 0.05, ((1, 1), (2, 0.3)), 50), 0.35)
    save("focus", tone(560, 0.04, ((1, 1),), 60), 0.25)


def scrape():
    """Wood over grass, a second that loops: its end runs into its beginning."""
    long = noise(1.25, 0, 0.03, 0.12, seed=7)
    over, count = int(0.25 * RATE), RATE
    grain = [1 + 0.35 * math.sin(2 * math.pi * 9 * i / count) for i in range(count)]
    out = [long[i] * (i / over) + long[count + i] * (1 - i / over) if i < over else long[i] for i in range(count)]
    return [value * g for value, g in zip(out, grain)]


# ---- music

MARIMBA = ((1, 1.0), (4, 0.25), (9.2, 0.05))
GUITAR = ((1, 1.0), (2, 0.55), (3, 0.3), (4, 0.15), (5, 0.08))
PAD = ((1, 1.0), (2, 0.35), (3, 0.12))
BASS = ((1, 1.0), (2, 0.35), (3, 0.1))

# Eight beats a line: a melody note for every half beat, "." holds. Chords for each four beats.
MEADOW = {
    "beat": 0.5, "lead": MARIMBA, "lead_decay": 5.0, "pad": 0.0, "shaker": 0.05,
    "chords": ["c e g", "a c e", "f a c", "g b d", "c e g", "a c e", "d f a", "g b d",
               "f a c", "c e g", "f a c", "g b d", "a c e", "e g b", "d f a", "g b d"],
    "melody": ["e5 . g5 . c6 . b5 g5 a5 . e5 . . . g5 .", "f5 . a5 . c6 . a5 f5 g5 . . . d5 . . .",
               "e5 . g5 . c6 . d6 c6 a5 . e5 . . . a5 .", "f5 . e5 . d5 . f5 . g5 . . . . . g5 .",
               "a5 . . c6 a5 . f5 . g5 . . e5 c5 . . .", "a5 . . c6 d6 . c6 a5 b5 . g5 . . . b5 .",
               "c6 . b5 . a5 . e5 . g5 . b5 . e5 . . .", "f5 . a5 . d6 . c6 . b5 . g5 . . . . ."],
}
DUSK = {
    "beat": 0.68, "lead": GUITAR, "lead_decay": 3.0, "pad": 0.22, "shaker": 0.0,
    "chords": ["a c e", "f a c", "c e g", "g b d", "a c e", "f a c", "d f a", "e g b"],
    "melody": ["a5 . . e5 . . c5 . f5 . . e5 . c5 . .", "g5 . . e5 . . c5 . d5 . . . b4 . . .",
               "a5 . . b5 . . c6 . a5 . . f5 . . . .", "f5 . . e5 d5 . . . e5 . . . b4 . . ."],
}


def music(song):
    beat = song["beat"]
    length = int(len(song["chords"]) * 4 * beat * RATE)
    out = [0.0] * length

    def add(start, loudness, sound):           # what rings on past the end sounds at the beginning: so it loops
        first = int(start * RATE)
        for i, value in enumerate(sound):
            out[(first + i) % length] += loudness * value

    for bar, line in enumerate(song["melody"]):
        for half, name in enumerate(line.split()):
            if name != ".":
                add((bar * 8 + half / 2) * beat, 0.5, tone(note(name), 1.2, song["lead"], song["lead_decay"]))
    rnd = random.Random(3)
    for bar, chord in enumerate(song["chords"]):
        names = chord.split()
        start = bar * 4 * beat
        add(start, 0.55, tone(note(names[0] + "2"), 1.6 * beat, BASS, 2.5))
        add(start + 2.5 * beat, 0.4, tone(note(names[2] + "2"), 1.2 * beat, BASS, 3.0))
        for half, which in enumerate((0, 2, 1, 2, 0, 2, 1, 2)):
            octave = "4" if which else "3"
            add(start + half / 2 * beat, 0.17, tone(note(names[which] + octave), 0.9, GUITAR, 5.0))
        if song["pad"]:
            for name in names:
                add(start, song["pad"] / 3, tone(note(name + "4"), 4.6 * beat, PAD, 0.35, attack=0.9))
        if song["shaker"]:
            for half in range(8):
                add(start + half / 2 * beat, song["shaker"] * (1 if half % 2 else 0.5), noise(0.06, 55, 0.5, 0.9, seed=rnd.randrange(99)))
    return out


if __name__ == "__main__":
    effects()
    save("meadow", music(MEADOW), 0.6, 1)
    save("dusk", music(DUSK), 0.6, 1)
