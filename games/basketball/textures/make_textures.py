#!/usr/bin/env python3
"""Makes the game's textures out of noise: python3 make_textures.py. All but the ball's go on at their edges; most are
nearly white, so that a material's color tints them."""
import math, os, random, struct, zlib

os.chdir(os.path.dirname(os.path.abspath(__file__)))
random.seed(3)

def save(name, width, height, pixel, alpha=False):
    rows = b""
    for y in range(height):
        rows += b"\0" + b"".join(bytes(max(0, min(255, round(c * 255))) for c in pixel(x, y)) for x in range(width))
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    head = struct.pack(">IIBBBBB", width, height, 8, 6 if alpha else 2, 0, 0, 0)
    with open(name + ".png", "wb") as f:
        f.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))

def clouds(size, cells):
    """Smooth noise that goes on at its edges, 0 to 1."""
    grid = [[random.random() for _ in range(cells)] for _ in range(cells)]
    def at(x, y):
        u, v = x * cells / size, y * cells / size
        i, j = int(u), int(v)
        a, b = u - i, v - j
        a, b = a * a * (3 - 2 * a), b * b * (3 - 2 * b)
        g = lambda p, q: grid[q % cells][p % cells]
        return (g(i, j) * (1 - a) + g(i + 1, j) * a) * (1 - b) + (g(i, j + 1) * (1 - a) + g(i + 1, j + 1) * a) * b
    return at

# ---- asphalt: patches, grains and a few bright stones
SIZE = 256
patches, grains = clouds(SIZE, 6), clouds(SIZE, 96)
stones = [[random.random() for _ in range(SIZE)] for _ in range(SIZE)]
def asphalt(x, y):
    v = 0.8 + 0.1 * patches(x, y) + 0.14 * (grains(x, y) - 0.5) + 0.1 * (stones[y][x] - 0.5)
    if stones[y][x] > 0.992: v += 0.12
    return v, v, v
save("asphalt", SIZE, SIZE, asphalt)

# ---- wood: four planks with grain along x
fibre = clouds(SIZE, 8)
tones = [0.92, 0.84, 0.97, 0.88]
lines = [random.random() for _ in range(SIZE)]
def wood(x, y):
    plank, inside = divmod(y, SIZE // 4)
    if inside < 2 or inside > SIZE // 4 - 2: return 0.45, 0.42, 0.4
    wave = y + 5 * fibre(x, (plank * 61) % SIZE)
    v = tones[plank] * (0.92 + 0.08 * math.sin(wave * 0.55)) - 0.1 * lines[int(wave) % SIZE] * fibre((x * 2) % SIZE, y)
    return v, v * 0.985, v * 0.96
save("wood", SIZE, SIZE, wood)

# ---- leather: pebbles, each a small bump lit from above
def leather(x, y):
    row = y // 6
    u, v = (x + (row % 2) * 3) % 6 - 2.5, y % 6 - 2.5
    far = math.hypot(u, v)
    light = 0.84 + (0.14 - 0.05 * v / 2.5 if far < 2.4 else -0.1)
    return light, light * 0.98, light * 0.95
save("leather", 384, 192, leather)

# ---- a house by night: eight by eight windows, some lit, of 4 by 4 pixels and a wall between
lit = [[random.random() for _ in range(8)] for _ in range(8)]
def windows(x, y):
    i, j, u, v = x // 16, y // 16, x % 16, y % 16
    if not (4 <= u < 12 and 3 <= v < 12): return 0.36, 0.3, 0.46
    if u == 8 - 1 or v == 7: return 0.42, 0.34, 0.46
    chance = lit[j][i]
    if chance < 0.3: return 1.0, 0.82 - chance, 0.42
    return 0.27, 0.25, 0.4
save("windows", 128, 128, windows)

# ---- wire netting: two wires that cross in a diamond
def fence(x, y):
    a, b = (x + y) % 64, (x - y) % 64
    far = min(abs(a - 32), abs(b - 32))
    if far > 4: return 0.75, 0.72, 0.8, 0
    v = 0.95 - 0.09 * far
    return v, v, v, 1 if far < 4 else 0.5
save("fence", 64, 64, fence, True)
