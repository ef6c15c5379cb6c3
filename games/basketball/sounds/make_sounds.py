#!/usr/bin/env python3
"""Makes the game's sounds out of sines and noise: python3 make_sounds.py. Needs ffmpeg for the OGG files."""
import math, os, random, struct, subprocess, wave

RATE = 32000
TAU = 2 * math.pi
os.chdir(os.path.dirname(os.path.abspath(__file__)))
random.seed(7)

def seconds(length, fn):
    return [fn(i / RATE) for i in range(int(length * RATE))]

def mix(*parts):
    longest = max(len(p) for p in parts)
    return [sum(p[i] for p in parts if i < len(p)) for i in range(longest)]

def at(start, part):
    return [0.0] * int(start * RATE) + part

def noise(length):
    return seconds(length, lambda t: random.uniform(-1, 1))

def shaped(part, envelope):
    return [x * envelope(i / RATE) for i, x in enumerate(part)]

def decay(half):
    return lambda t: 0.5 ** (t / half)

def hump(length, peak):
    """Rises to 1 at `peak` seconds and falls to 0 at `length`."""
    return lambda t: (t / peak) if t < peak else max(0.0, 1 - (t - peak) / (length - peak)) ** 2

def band(part, frequency, q):
    """A band pass; the frequency may be a function of time."""
    low = high = 0.0
    out = []
    for i, x in enumerate(part):
        f = frequency(i / RATE) if callable(frequency) else frequency
        k = 2 * math.sin(math.pi * min(f, RATE / 6.5) / RATE)
        low += k * high
        high += k * (x - low - high / q)
        out.append(high)
    return out

def partials(length, table):
    """(frequency, loudness, half-life) each."""
    return mix(*[seconds(length, lambda t, f=f, a=a, h=h: a * math.sin(TAU * f * t) * 0.5 ** (t / h)) for f, a, h in table])

def thump(length, high, low, half):
    """A drum's skin: its pitch falls while it dies away."""
    phase, out = 0.0, []
    for i in range(int(length * RATE)):
        t = i / RATE
        phase += TAU * (low + (high - low) * 0.5 ** (t / 0.018)) / RATE
        out.append(math.sin(phase) * 0.5 ** (t / half))
    return out

def faded(part, length=0.01):
    n = int(length * RATE)
    return [x * min(1, i / 24, (len(part) - i) / n) for i, x in enumerate(part)]

def looped(part, over):
    """Its end runs over into its beginning, so that it goes round without a click."""
    n = int(over * RATE)
    head, tail = part[:n], part[-n:]
    # Equal power: what is mixed here is noise.
    blend = [h * math.sin(i / n * math.pi / 2) + t * math.cos(i / n * math.pi / 2) for i, (h, t) in enumerate(zip(head, tail))]
    return blend + part[n:-n]

def save(name, part, peak=0.85, quality=3, loop=False):
    part = part if loop else faded(part)
    top = max(abs(x) for x in part)
    data = b"".join(struct.pack("<h", int(32767 * peak * x / top)) for x in part)
    with wave.open(name + ".wav", "wb") as f:
        f.setnchannels(1); f.setsampwidth(2); f.setframerate(RATE); f.writeframes(data)
    subprocess.run(["ffmpeg", "-loglevel", "error", "-y", "-i", name + ".wav", "-map_metadata", "-1", "-fflags", "+bitexact",
                    "-flags:a", "+bitexact", "-c:a", "libvorbis", "-q:a", str(quality), name + ".ogg"], check=True)
    os.remove(name + ".wav")

# ---- the ball
save("bounce", mix(thump(0.35, 210, 82, 0.05),
                   shaped(band(noise(0.06), 900, 1.5), lambda t: 0.9 * decay(0.008)(t)),
                   partials(0.3, [(196, 0.25, 0.04), (523, 0.1, 0.03)])))
save("rim", mix(partials(0.9, [(433, 0.7, 0.14), (911, 0.8, 0.11), (1397, 0.5, 0.09), (2210, 0.45, 0.06), (3170, 0.3, 0.04)]),
                thump(0.2, 260, 130, 0.03), shaped(noise(0.02), decay(0.003))))
save("board", mix(thump(0.4, 240, 118, 0.06), partials(0.4, [(331, 0.5, 0.05), (507, 0.3, 0.04)]),
                  shaped(band(noise(0.1), 1600, 1.2), lambda t: 0.7 * decay(0.012)(t))))
save("swish", mix(shaped(band(noise(0.5), lambda t: 3800 - 4200 * t, 1.6), hump(0.5, 0.07)),
                  at(0.09, shaped(band(noise(0.35), lambda t: 2300 - 2600 * t, 2), lambda t: 0.7 * hump(0.35, 0.05)(t)))))
save("throw", shaped(band(noise(0.28), lambda t: 500 + 2600 * t, 1.4), hump(0.28, 0.09)))

# ---- the targets
save("plate", mix(partials(1.1, [(587, 0.8, 0.2), (1181, 0.5, 0.16), (1702, 0.45, 0.11), (2603, 0.3, 0.07)]),
                  shaped(noise(0.015), decay(0.003))))
chime = mix(*[at(0.07 * i, partials(0.9, [(f, 0.5, 0.16), (2 * f, 0.25, 0.1), (3.01 * f, 0.12, 0.06)]))
              for i, f in enumerate([784, 988, 1175, 1568, 1976])])
save("snap", mix(shaped(band(noise(0.25), 2400, 0.8), lambda t: 2.2 * decay(0.02)(t)), thump(0.3, 320, 90, 0.05), at(0.08, chime)))

# ---- points: played higher with each one of a streak
save("points", mix(partials(0.6, [(660, 0.6, 0.12), (1320, 0.3, 0.08)]), at(0.08, partials(0.6, [(880, 0.7, 0.14), (1760, 0.3, 0.09), (2640, 0.1, 0.05)]))))

# ---- people: many voices, each a buzz that glides through the mouth's two resonances; and hands
def voice(length, pitch):
    glide, wobble, phase, out = random.uniform(0.9, 1.25), random.uniform(4, 7), 0.0, []
    for i in range(int(length * RATE)):
        t = i / RATE
        f = pitch * (1 + (glide - 1) * min(1, t / 0.5)) * (1 + 0.012 * math.sin(TAU * wobble * t))
        phase = (phase + f / RATE) % 1
        out.append(2 * phase - 1 + random.uniform(-0.35, 0.35))
    first, second = random.uniform(620, 860), random.uniform(1050, 1500)
    return shaped(mix(band(out, first, 5), [0.6 * x for x in band(out, second, 7)]), hump(length, random.uniform(0.12, 0.35)))

def clap():
    return shaped(band(noise(0.05), random.uniform(900, 1700), 1.6), decay(0.007))

def crowd(length, voices, claps):
    parts = [at(random.uniform(0, 0.35), voice(random.uniform(0.7, length - 0.4), random.uniform(150, 380))) for _ in range(voices)]
    hands = [at(random.uniform(0.15, length - 0.1) , [random.uniform(0.5, 1.2) * x for x in clap()]) for _ in range(claps)]
    return shaped(mix(*parts, *hands), lambda t: max(0.0, 1 - (t / length) ** 3))
save("cheer", crowd(2.0, 16, 60), quality=2)

# ---- the clock and the buttons
save("tick", partials(0.12, [(1250, 0.8, 0.015), (2500, 0.3, 0.008)]))
save("buzzer", shaped(seconds(1.1, lambda t: sum(math.copysign(0.5, math.sin(TAU * f * t)) for f in (196, 207, 294))), lambda t: min(1, t / 0.01, (1.1 - t) / 0.08)), peak=0.6)
save("click", mix(partials(0.1, [(1050, 0.6, 0.01), (1570, 0.4, 0.008)]), shaped(noise(0.008), decay(0.002))))
save("whistle", seconds(0.55, lambda t: math.sin(TAU * 2300 * t + 9 * math.sin(TAU * 31 * t)) * min(1, t / 0.03, (0.55 - t) / 0.06)), peak=0.5)

# ---- the evening: wind in the trees, and crickets, as a loop
def cricket(t, f, every, offset):
    u = (t + offset) % every
    return math.sin(TAU * f * t) * (0.5 - 0.5 * math.cos(TAU * 34 * u)) if u < 0.24 else 0.0
# Every period divides the loop's 8 seconds, so that a chirp that crosses the seam goes on.
gusts = lambda t: 420 + 160 * math.sin(TAU * t / 4)
air = looped(shaped(band(band(noise(9), gusts, 0.8), 380, 0.8), lambda t: 0.6 + 0.25 * math.sin(TAU * t / 8)), 1)
insects = seconds(8, lambda t: 0.025 * cricket(t, 4150, 0.8, 0) + 0.018 * cricket(t, 4420, 1.0, 0.4) + 0.015 * cricket(t, 3890, 1.6, 0.9))
save("evening", mix([0.8 * x for x in air], insects), peak=0.5, quality=1, loop=True)

# ---- the title's music: electric piano, bass and a soft beat, eight bars that go round
BEAT = 60 / 88
def key(f, length):
    """Two sines, one bending the other, which is what an electric piano comes to."""
    return seconds(length, lambda t: math.sin(TAU * f * t + 1.3 * 0.5 ** (t / 0.25) * math.sin(TAU * 2 * f * t)) * 0.5 ** (t / 0.7) * min(1, t / 0.006, (length - t) / 0.05))
def bass(f, length):
    return seconds(length, lambda t: (math.sin(TAU * f * t) + 0.25 * math.sin(TAU * 2 * f * t)) * 0.5 ** (t / 0.5) * min(1, t / 0.01, (length - t) / 0.03))
def note(n):
    return 440 * 2 ** ((n - 69) / 12)

song = [0.0] * int(32 * BEAT * RATE)
def put(beat, part, loud):
    start = int(beat * BEAT * RATE)
    for i, x in enumerate(part):
        song[(start + i) % len(song)] += loud * x   # what rings on past the end is heard at the beginning
chords = [(53, [60, 64, 67, 69]), (52, [59, 62, 67, 71]), (50, [57, 60, 65, 69]), (55, [59, 62, 65, 69]),
          (53, [60, 64, 67, 69]), (52, [59, 62, 67, 71]), (50, [57, 60, 64, 65]), (48, [55, 59, 64, 67])]
melody = {0.5: 76, 1.5: 79, 2: 81, 3.5: 79, 6: 76, 7: 74, 8.5: 72, 9.5: 74, 10: 76, 12.5: 74, 14: 71, 15: 67,
          16.5: 76, 17.5: 79, 18: 84, 19.5: 81, 22: 79, 23: 76, 24.5: 77, 25.5: 76, 26: 72, 28: 74, 29.5: 72}
for bar, (root, notes) in enumerate(chords):
    for beat in (0, 1.5, 2.75):
        for n in notes: put(bar * 4 + beat + 0.008 * (n % 5), key(note(n), 1.4), 0.085 if beat else 0.11)
    for beat, step in ((0, 0), (1.5, 0), (2.5, 7), (3.5, 12)): put(bar * 4 + beat, bass(note(root - 12 + step - (12 if root > 52 else 0)), 0.6), 0.34)
    for beat in (0, 2.5): put(bar * 4 + beat, thump(0.25, 150, 52, 0.06), 0.55)
    for beat in (1, 3): put(bar * 4 + beat, mix(shaped(band(noise(0.18), 1900, 1), decay(0.03)), thump(0.1, 260, 180, 0.02)), 0.3)
    for beat in range(8): put(bar * 4 + beat / 2 + (0.06 if beat % 2 else 0), shaped(band(noise(0.06), 4600, 1), decay(0.009)), 0.16 if beat % 2 else 0.09)
for beat, n in melody.items(): put(beat, key(note(n), 1.1), 0.16)
save("music", song, peak=0.7, quality=2, loop=True)
