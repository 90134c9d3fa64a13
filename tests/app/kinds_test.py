"""Tests placedpar kinds: one kind, a group, all; for people and for machines."""

import json
import pathlib
import re
import shlex
import unittest

from program import CLUSTER, EXAMPLES, placedpar


def said(*arguments):
    done = placedpar("kinds", *arguments)
    assert done.returncode == 0, done.stderr
    return done.stdout


def refusal(*arguments):
    done = placedpar(*arguments)
    assert done.returncode == 1, done.stdout
    return done.stderr


def number(value):
    """Formats the JSON entry like the text."""
    return f"{value:g}" if isinstance(value, float) and abs(value) < 1e5 else str(int(value))


def range_of(parameter):
    if parameter["choices"]:
        return " | ".join(parameter["choices"])
    if parameter["type"] == "string":
        return "text"
    ends = ["" if parameter[end] is None else number(parameter[end]) for end in ("least", "most")]
    return f"{ends[0]} .. {ends[1]}"


def default_of(value):
    return "none" if value is None else f'"{value}"' if isinstance(value, str) else number(value) if value == int(value) \
        else repr(value)


class Kinds(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.all = json.loads(said("--json"))

    def test_a_group_lists_its_kinds(self):
        names = [kind["name"] for kind in self.all["processes"]]
        for group in ("csp", "ga"):
            lines = said(group).splitlines()
            self.assertEqual(lines[0], group)
            self.assertEqual([line.split()[0] for line in lines[1:]], [n for n in names if n.startswith(group + ".")])
            self.assertGreater(len(lines), 4)
            for line in lines[1:]:
                self.assertIn(line, said().splitlines())
        self.assertIn(said("devices"), said())
        self.assertIn(said("processes"), said())

    def test_both_forms_name_the_same_kinds(self):
        listed = said().split("\ndevices\n")
        names = [line.split()[0] for line in listed[0].splitlines()[1:]]
        self.assertEqual([kind["name"] for kind in self.all["processes"]], names)
        models = {model["name"] for device in self.all["devices"] for model in device["models"]}
        for name in ("T800", "t800", "B404", "B403_T414", "C004", "workstation", "edge", "processor", "VME"):
            self.assertIn(name, models)
        for word in re.findall(r"^ {19}(.*)$", listed[1], re.MULTILINE)[0].split():
            self.assertIn(word, models)

    def check_parameter(self, parameter, text, default):
        line = next(line for line in text.splitlines() if line.split()[:1] == [parameter["name"]] and "default" in line)
        self.assertEqual(line.split()[1:4:2], [parameter["type"], default_of(default).split()[0]], line)
        self.assertIn(range_of(parameter), line)
        self.assertTrue(line.rstrip().endswith(parameter["unit"]), line)
        self.assertIn(parameter["about"], text)

    def test_processes_are_the_same_in_both_forms(self):
        for kind in self.all["processes"]:
            text = said(kind["name"])
            self.assertTrue(text.startswith(f"{kind['name']}\n{kind['about']}\n"))
            for port in kind["ports"]:
                line = next(line for line in text.splitlines() if line.split()[:2] == [port["name"], port["direction"]])
                self.assertIn(f"{port['protocol']:<14} {port['about']}", line)
                self.assertEqual("(may stay unconnected)" in line, port["may_stay_unconnected"])
            for parameter in kind["parameters"]:
                self.check_parameter(parameter, text, parameter["default"])
            for measure in kind["measures"]:
                self.assertIn(f"  {measure['name']:<28} {measure['unit']:<7} {measure['about']}\n", text)
            entries = len(kind["ports"]) + 2 * len(kind["parameters"]) + len(kind["measures"])
            self.assertEqual(sum(line.startswith("  ") for line in text.splitlines()), entries)

    def test_devices_are_the_same_in_both_forms(self):
        for device in self.all["devices"]:
            for model in device["models"]:
                text = said(model["name"])
                self.assertIn(device["about"], text)
                if device["refusal"]:
                    self.assertIn(device["refusal"], text)
                    continue
                if model["links"] and not model["needs_type"]:
                    self.assertIn(f"links: {model['links']}", text)
                self.assertEqual("can be placed on it" in text and "none can" not in text, device["runs_processes"])
                for attribute in device["attributes"]:
                    self.check_parameter(attribute, text, model["defaults"].get(attribute["name"], attribute["default"]))
                for kept in device["without_effect"]:
                    self.assertIn(kept, text)

    def test_what_has_links_has_their_faults(self):
        for name, has_links in (("T800", True), ("C012", True), ("workstation", True), ("C004", False), ("VME", False)):
            self.assertEqual("faults of its links" in said(name), has_links, name)

    def test_one_kind_or_a_group_for_machines(self):
        by_name = {kind["name"]: kind for kind in self.all["processes"]}
        self.assertEqual(json.loads(said("ga.master", "--json")), {"processes": [by_name["ga.master"]], "devices": []})
        group = json.loads(said("csp", "--json"))["processes"]
        self.assertEqual(group, [kind for name, kind in by_name.items() if name.startswith("csp.")])
        module = json.loads(said("B404", "--json"))["devices"]
        self.assertEqual([model["name"] for model in module[0]["models"]], ["B404"])
        self.assertEqual(module[0]["models"][0]["defaults"], {"memory": 2 * 1024 * 1024})
        self.assertEqual(json.loads(said("devices", "--json")), {"processes": [], "devices": self.all["devices"]})

    def test_problems_are_named_with_their_numbers(self):
        listed = said("problems").splitlines()
        self.assertEqual(listed[0], "problems")
        names = [line.split()[0].split("(")[0] for line in listed[1:] if line[2] != " "]
        self.assertEqual(names.pop(), "tsp:FILE")  # which has no description without a file
        self.assertEqual(names, [each["name"] for each in json.loads(said("problems", "--json"))["problems"]])
        for name in ("boom", "rastrigin", "trap", "nk", "tour-circle"):
            self.assertIn(name, names)
            self.assertTrue(said(name).startswith(name + "\n"))
        self.assertIn("string: 60 bits", said("rastrigin(dimensions = 6, bits = 10)"))
        self.assertEqual(json.loads(said("one-max(4096)", "--json"))["problems"][0]["optimum"], 4096)
        self.assertIn("dimensions = 0 is out of range", refusal("kinds", "rastrigin(0)"))

    def test_every_number_of_a_problem_says_what_it_is(self):
        for problem in json.loads(said("problems", "--json"))["problems"]:
            text = said(problem["name"])
            for each in problem["numbers"]:
                self.assertTrue(each["about"], (problem["name"], each["name"]))
                self.assertIn(each["about"], text)

    def test_what_problems_are_about_stands_in_one_column(self):
        lines = said("problems").splitlines()[1:]
        alone = ["  coefficients(form = 2, bias = 10, samples = 30, noise = 0, record = 1)",
                 "  costly(dimensions = 2, bits = 16, work = 1)",
                 "  plant(a1 = 0.5, from = 200, lasts = 200, noise = 0, c1 = 0, c2 = 0, generations = 601, per_sample = 3, simulated = 0)",
                 "  quartic(dimensions = 30, bits = 8, noise = 1, seed = 1)"]
        self.assertEqual([line.rstrip() for line in lines if line.rstrip() in alone], alone)
        for line in lines:
            if line.rstrip() not in alone:
                self.assertEqual((line[44], line[45] != " "), (" ", True), line)

    def test_policies_are_the_same_in_both_forms(self):
        listed = said("policies")
        nouns = json.loads(said("policies", "--json"))["policies"]
        self.assertEqual([line.split()[0] for line in listed.splitlines()[1:] if line[2] != " "],
                         [noun["name"] for noun in nouns])
        for noun in nouns:
            text = said(noun["name"])
            self.assertTrue(text.startswith(f"{noun['name']}\n{noun['about']}\n"))
            for parameter in noun["parameters"]:
                self.check_parameter(parameter, text, parameter["default"])
                self.assertIn(f"of {', '.join(parameter['kinds'])}\n", text)
                self.assertEqual(parameter["decides"], noun["name"])
            for policy in noun["policies"]:
                self.assertIn(f"{policy['name']}", listed)
                self.assertIn(f"\n{policy['written']}\n  {policy['about']}\n", text)
                self.assertIn(f"  source: {policy['source']}\n", text)
                for each in policy["numbers"]:
                    self.assertRegex(text, rf"{each['name']} +(int|double) +default {default_of(each['default'])} +"
                                           rf"{number(each['least'])} .. {number(each['most'])}\n"
                                           rf" +{re.escape(each['about'])}\n")
            for form in noun["forms"]:
                self.assertRegex(listed, rf"(?m)^    {form['name']} +{re.escape(form['about'])}$")
                self.assertIn(f"\n{form['name']}\n  {form['about']}\n", text)
                self.assertIn(f"  in a netlist: {form['written']}\n" if form["written"] else "  of the library alone\n", text)
                self.assertIn(f"  source: {form['source']}\n  example: placedpar {form['example']}\n", text)
        self.assertIn("initial-population", listed)

    def test_what_no_policy_decides_is_seen_in_an_example(self):
        for noun in json.loads(said("policies", "--json"))["policies"]:
            for form in noun["forms"]:
                command, *arguments = shlex.split(form["example"])
                if command == "replay":
                    self.assertIn(f"\n  {arguments[0]} ", refusal("replay", "everything"))
                    continue
                self.assertEqual(command, "run")
                path = EXAMPLES.parent / arguments[0]
                done = placedpar("check", *arguments, folder=EXAMPLES.parent)
                self.assertEqual((done.returncode, done.stderr), (0, ""), form)
                seen = path.read_text() + form["example"]
                for parameter, kind, port in re.findall(r"(\w+) = |\"(ga\.\w+)\"|\.(\w+)", form["written"]):
                    self.assertIn(parameter or kind or port, seen, form)

    def test_every_noun_is_found_by_the_words_for_it(self):
        for words, nouns in (("distributed fitness", ["distributed-fitness"]), ("coarse/fine", ["coarse-fine"]),
                             ("Initial Population", ["initial-population"]), ("fitness", ["fitness"]),
                             ("window", ["window"]), ("bias", ["fitness"]), ("farm", ["farm"]), ("tree", ["farm"]),
                             ("permutation", ["representation"]), ("mutation_rate", ["mutation"]),
                             ("migration", ["topology", "schedule", "emigration", "acceptance"]),
                             ("active error analysis", ["choice"]), ("operator", ["crossover", "mutation"])):
            found = json.loads(said(words, "--json"))["policies"]
            self.assertEqual([noun["name"] for noun in found], nouns, words)

    def test_a_policy_with_numbers_of_its_own(self):
        self.assertIn('reproduction = "tournament(size = 3)"', said("Tournament(3)"))
        self.assertEqual([noun["name"] for noun in json.loads(said("uniform", "--json"))["policies"]],
                         ["crossover", "mutation"])
        self.assertEqual(refusal("kinds", "ranking(3)"),
                         "placedpar: best = 3 is out of range: best is a number from 1 to 2\n")

    def test_a_misspelt_name_gets_the_nearest(self):
        for wrong, right in (("mastr", "ga.master"), ("master", "ga.master"), ("ga.mastr", "ga.master"), ("cps", "csp"),
                             ("T80", "T800"), ("t80", "t800"), ("workstaton", "workstation"), ("device", "devices"),
                             ("csp.prod", "csp.producer"), ("trad", "ga.traditional"), ("rastrigen", "rastrigin"),
                             ("selecton", "selection"), ("rouletta", "roulette"), ("polices", "policies")):
            for form in ((), ("--json",)):
                self.assertEqual(refusal("kinds", wrong, *form), "placedpar: unknown process kind, device, problem "
                                                                 f'or policy "{wrong}"; did you mean "{right}"?\n')
        self.assertIn("placedpar kinds lists all", refusal("kinds", "zebra"))


    def test_the_case_of_letters_does_not_matter(self):
        for typed, name in (("b404", "B404"), ("c004", "C004"), ("CSP.Prefix", "csp.prefix"), ("CSP", "csp"),
                            ("Devices", "devices")):
            for form in ((), ("--json",)):
                self.assertEqual(said(typed, *form), said(name, *form))

    def test_what_a_rate_is_of(self):
        self.assertRegex(said("ga.island"), r"generations_per_second +1/s +generations of this process's own population")


class OtherNames(unittest.TestCase):
    def test_a_misspelt_name_gets_the_nearest(self):
        self.assertEqual(refusal("rnu"), 'placedpar: unknown command "rnu"; did you mean "run"?\n')
        self.assertEqual(refusal("replay", "tabel-e1"),
                         'placedpar: unknown experiment "tabel-e1"; did you mean "table-e1"?\n')
        self.assertEqual(refusal("record", "excavatr"),
                         'placedpar: unknown scenario "excavatr"; did you mean "excavator"?\n')
        self.assertEqual(refusal("run", "x.cfs", "--sead", "3"),
                         'placedpar: unknown option "--sead"; did you mean "--seed"?\n')
        self.assertEqual(refusal("run", "x.cfs", "--jsn=x"),
                         'placedpar: unknown option "--jsn"; did you mean "--json"?\n')
        self.assertEqual(refusal("--versoin"), 'placedpar: unknown option "--versoin"; did you mean "--version"?\n')

    def test_words_of_other_programs_and_netlists_get_what_is_meant(self):
        for words, meant in ((["help"], "--help"), (["help", "run"], "run --help"), (["help", "me"], "--help"),
                             (["version"], "--version"), (["mine.cfs"], "run mine.cfs"), (["MINE.CFS"], "run MINE.CFS"),
                             ([str(CLUSTER)], f"run {CLUSTER}")):
            self.assertEqual(refusal(*words), f'placedpar: unknown command "{words[0]}"; did you mean placedpar {meant}?\n')

    def test_a_shell_that_is_not_known(self):
        said = refusal("completion", "fish")
        self.assertIn('no completion for the shell "fish"; expected bash or zsh', said)
        self.assertNotIn("words", said)

    def test_what_is_near_to_nothing_is_told_where_to_look(self):
        self.assertIn("placedpar run --help lists the options", refusal("run", "x.cfs", "--quux"))
        self.assertIn("placedpar --help lists the commands", refusal("fly"))
        self.assertIn("the experiments are:\n  table-2-6", refusal("replay", "everything"))
        self.assertEqual(refusal("check", "a.cfs", "b.cfs"), 'placedpar: placedpar check takes no further argument: "b.cfs"\n')


if __name__ == "__main__":
    unittest.main()
