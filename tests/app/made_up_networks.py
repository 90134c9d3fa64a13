"""Makes networks of many forms, for tests that draw them."""

import random

RING = """T800 t[n];
process (interface (output out, input in)) p[n];
rep i = 0 for n {
    connect t[i].link[1] to t[(i + 1) % n].link[0];
    use "csp.identity" for p[i];
    connect p[i].out to p[(i + 1) % n].in;
    place p[i] on t[i];
}
"""
TORUS = """T805 (memory = 1M) t[n][n];
process (interface (output out, input in)) p[n][n];
rep i = 0 for n rep j = 0 for n {
    connect t[i][j].link[1] to t[i][(j + 1) % n].link[3];
    connect t[i][j].link[2] to t[(i + 1) % n][j].link[0];
    use "csp.prefix" for p[i][j];
    connect p[i][j].out to p[i][(j + 1) % n].in;
    place p[i][j] on t[i][j];
}
"""
CUBE = """val n 1 << k;
T800 t[n];
rep i = 0 for n rep b = 0 for k
    if (i >> b) % 2 == 0 connect t[i].link[b] to t[i + (1 << b)].link[b];
"""
STAR = """T800 hub, spoke[4];
process (interface (output out)) p[4];
process (interface (input in)) q[4];
rep i = 0 for 4 {
    connect hub.link[i] to spoke[i].link[0];
    use "csp.producer" for p[i];
    use "csp.consumer" for q[i];
    place p[i] on spoke[i];
    place q[i] on hub;
    connect p[i].out to q[i].in;
}
"""
CHAIN = """T800 t[n];
rep i = 0 for n - 1 connect t[i].link[1] to t[i + 1].link[0];
connect t[0].link[0] to host;
"""
SWITCH = """T800 t[n];
C004 sw;
rep i = 0 for n {
    connect t[i].link[0] to sw.link[2 * i];
    connect t[i].link[1] to sw.link[2 * i + 1];
    connect sw.link[2 * i + 1] to sw.link[(2 * (i + 1)) % (2 * n)];
}
"""
SINGLE = """T800 root;
process (interface (output out)) p[6];
process (priority = HIGH, interface (input in)) q[6];
rep i = 0 for 6 {
    use "csp.producer" for p[i];
    use "csp.consumer" for q[i];
    place p[i] on root;
    place q[i] on root;
    connect p[i].out to q[i].in;
}
"""
TREE = """T800 t[15];
rep i = 0 for 7 {
    connect t[i].link[1] to t[2 * i + 1].link[0];
    connect t[i].link[2] to t[2 * i + 2].link[0];
}
connect t[0].link[0] to host;
"""
MADE_UP = {
    "torus-4": "val n 4;\n" + TORUS, "torus-8": "val n 8;\n" + TORUS, "ring-16": "val n 16;\n" + RING,
    "ring-3": "val n 3;\n" + RING, "cube": "val k 3;\n" + CUBE, "hypercube": "val k 4;\n" + CUBE, "star": STAR,
    "chain": "val n 12;\n" + CHAIN, "switch": "val n 16;\n" + SWITCH, "single": SINGLE, "tree": TREE,
    "alone": "T800 a;\n",
    "unconnected": "T800 a, b; C004 sw; edge out;\nconnect a.link[0] to b.link[0];\nconnect a.link[3] to b.link[3];\n"
                   "connect b.link[1] to a.link[1];\n",
    "three dimensions": "T800 t[2][3][4];\nrep i = 0 for 2 rep j = 0 for 3 rep k = 0 for 3\n"
                        "    connect t[i][j][k].link[1] to t[i][j][k + 1].link[3];\n"
                        "rep j = 0 for 3 rep k = 0 for 4 connect t[0][j][k].link[0] to t[1][j][k].link[2];\n",
    "names": 'T800 a;\nprocess a_process_with_a_very_long_name_indeed_it_is;\n'
             'use "a<b>&\'c\'.lku" for a_process_with_a_very_long_name_indeed_it_is;\n'
             'place a_process_with_a_very_long_name_indeed_it_is on a;\n',
}


def random_network(seed):
    """Makes single transputers and arrays with randomly wired links."""
    stream = random.Random(seed)
    names = [f"s{i}" for i in range(stream.randrange(1, 7))] + [f"t[{i}]" for i in range(stream.randrange(2, 12))]
    ends = [f"{name}.link[{link}]" for name in names for link in range(3)]
    stream.shuffle(ends)
    singles = [name for name in names if name[0] == "s"]
    text = f"T800 {', '.join(singles)}, t[{len(names) - len(singles)}];\n"
    text += "".join(f"connect {a}.link[3] to {b}.link[3];\n" for a, b in zip(names[::2], names[1::2]))
    if len(names) % 2:
        text += f"connect {names[-1]}.link[3] to host;\n"
    return text + "".join(f"connect {a} to {b};\n" for a, b in zip(ends[::2], ends[1::2])
                          if a.split(".")[0] != b.split(".")[0] and stream.random() < 0.6)


TREE_OF = "rep i = 0 for {1} {{ connect {0}[i].link[1] to {0}[2 * i + 1].link[0]; connect {0}[i].link[2] to {0}[2 * i + 2].link[0]; }}\n"
RING_OF = "rep i = 0 for {1} connect {0}[i].link[1] to {0}[(i + 1) % {1}].link[0];\n"
SEVERAL_BLOCKS = {
    "two trees and a ring": "T800 a[255], b[63], c[24], d;\n" + TREE_OF.format("a", 127) + TREE_OF.format("b", 31) + RING_OF.format("c", 24) + """
        connect a[0].link[0] to b[0].link[0];
        connect a[254].link[1] to c[3].link[2];
        connect a[100].link[3] to c[9].link[2];
        connect c[11].link[2] to b[62].link[1];
        connect b[40].link[3] to a[130].link[3];
        connect d.link[0] to a[200].link[3];
        connect d.link[1] to host;
        """,
    "two rings": "T800 a[300], c[24];\n" + RING_OF.format("a", 300) + RING_OF.format("c", 24) + """
        rep i = 0 for 12 connect c[2 * i].link[2] to a[25 * i].link[2];
        connect a[7].link[3] to host;
        """,
    "a torus, a tree and a ring": "T800 a[16][16], b[15], c[9];\n" + TREE_OF.format("b", 7) + RING_OF.format("c", 9) + """
        rep i = 0 for 16 rep j = 0 for 16 {
            connect a[i][j].link[1] to a[i][(j + 1) % 16].link[3];
            if i * j connect a[i][j].link[2] to a[(i + 1) % 16][j].link[0];
        }
        connect b[0].link[0] to a[0][0].link[0];
        connect c[4].link[2] to a[0][5].link[2];
        connect c[7].link[2] to b[14].link[1];
        connect b[8].link[1] to host;
        """,
    "a torus, cubes and singles": "T800 a[15][15], b[8], c[24], d, e, f;\n" + """
        rep i = 0 for 15 rep j = 0 for 14 connect a[i][j].link[1] to a[i][j + 1].link[3];
        rep i = 0 for 8 rep k = 0 for 3 if (i >> k) % 2 == 0 connect b[i].link[k] to b[i + (1 << k)].link[k];
        rep i = 0 for 8 rep k = 0 for 3 {
            connect c[3 * i + k].link[0] to c[3 * i + (k + 1) % 3].link[1];
            if (i >> k) % 2 == 0 connect c[3 * i + k].link[2] to c[3 * (i + (1 << k)) + k].link[2];
        }
        rep k = 0 for 8 connect b[k].link[3] to a[k][k].link[0];
        rep k = 0 for 8 connect c[3 * k].link[3] to a[k][2 * k % 15].link[2];
        connect d.link[0] to a[9][0].link[0]; connect d.link[1] to e.link[0]; connect e.link[1] to f.link[0];
        connect f.link[1] to a[3][14].link[0]; connect f.link[2] to d.link[2]; connect d.link[3] to host;
        """}
