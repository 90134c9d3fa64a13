"""Tests the identification of DataFrames against that of their files by the command line, and its errors."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest
import warnings

import placedpar as pp

try:
    import pandas
except ImportError:
    pandas = None

HYDRAULICS = pathlib.Path(os.environ["PLACEDPAR_SOURCE"], "examples", "hydraulics")
RECORD = HYDRAULICS / "records" / "boom-two-steps.csv"


def rows(table):
    return table.to_dict("records")


@unittest.skipIf(pandas is None, "pandas is not installed")
class Identify(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.frame = pandas.read_csv(RECORD, comment="#", float_precision="round_trip")

    def command(self, *arguments):
        """Returns what the command line prints and its report."""
        report = self.folder / "report.json"
        printed = subprocess.run([os.environ["PLACEDPAR"], *arguments, "--json", report], check=True,
                                 stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout
        return printed, json.loads(report.read_text(encoding="utf-8"))

    def same(self, found, printed, typed):
        for key in ("version", "commit", "command", "seed", "warnings"):  # warnings have lines of the file
            typed.pop(key)
        found.report.pop("warnings")
        self.assertEqual(found.report, typed)
        self.assertEqual(str(found), printed)

    def test_a_frame_is_identified_as_its_file(self):
        for settings in ({}, {"way": "thesis", "seed": 7, "offset": 0.001, "bits": 8}, {"way": "whole", "links": ["boom"]},
                         {"areas_from": "servo", "population": 40}, {"side": "outlet", "areas_from": "servo"}):
            with self.subTest(settings):
                typed = [f"--{name.replace('_', '-')}={','.join(value) if isinstance(value, list) else value}"
                         for name, value in {"link": "boom", **settings}.items() if name != "links"]
                self.same(pp.identify(self.frame, **{"links": "boom", **settings}),
                          *self.command("identify", RECORD, *typed))

    def made(self, *arguments):
        """Returns a record that the command line makes, and its frame."""
        record = self.folder / "made.csv"
        subprocess.run([os.environ["PLACEDPAR"], "record", *arguments, "--out", record], check=True, stdout=subprocess.DEVNULL)
        return record, pandas.read_csv(record, comment="#", float_precision="round_trip")

    def test_a_frame_of_a_machine_that_digs_is_identified_as_its_file(self):
        record, frame = self.made("excavator", "--job", HYDRAULICS / "digging" / "dig.toml", "--noise", "low", "--seed", "3")
        found = pp.identify(frame)
        self.same(found, *self.command("identify", record))
        self.assertGreaterEqual(len({each["set"] for each in found.report["sets"]}), 4)

    def test_a_frame_of_several_pieces_is_identified_as_its_file(self):
        record, frame = self.made("excavator", "--set", "sensors.period=0.0005")
        frame = pandas.concat([frame.assign(**{"time [s]": frame["time [s]"] + 4.0005 * i}) for i in range(3)])
        frame["time [s]"] += ((frame.index % 7) - 3) * 2e-6  # jitters: readings are interpolated
        frame.to_csv(record, index=False)
        self.assertGreater(record.stat().st_size, 1 << 20)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            self.same(pp.identify(frame, population=20), *self.command("identify", record, "--population", "20"))

    def test_tables_have_the_movements_and_the_links(self):
        found = pp.identify(self.frame)
        link, = rows(found.links)
        self.assertEqual((link["link"], link["unit"], round(link["from_s"], 6)), ("boom", "in^3/psi", 0.5))
        self.assertAlmostEqual(link["compliance"], 0.0086, delta=4 * link["standard_error"])
        self.assertEqual(rows(found.verdicts)[0]["link"], "boom")
        self.assertAlmostEqual(rows(pp.identify(self.frame, way="thesis").links)[0]["compliance"], 0.0086, delta=1e-3)

    def test_the_unit_of_a_column_is_that_of_its_name(self):
        metric = self.frame.rename(columns={"boom.spool [in]": "boom.spool [mm]"})
        metric["boom.spool [mm]"] *= 25.4
        self.assertAlmostEqual(rows(pp.identify(metric).links)[0]["compliance"],
                               rows(pp.identify(self.frame).links)[0]["compliance"], 6)

    def test_columns_have_other_names(self):
        named = self.frame.rename(columns={"boom.angle [deg]": "Phi 1", "time [s]": "Zeit [s]"})
        found = pp.identify(named, columns={"boom.angle [deg]": "Phi 1", "time": "Zeit"})
        self.assertEqual(found.report, pp.identify(self.frame).report)
        names = self.folder / "names.txt"
        names.write_text("angle [deg] = Phi 1\ntime = Zeit\n", encoding="utf-8")
        self.assertEqual(pp.identify(named, columns_from=names).report, found.report)
        with self.assertRaisesRegex(pp.RecordError, 'name an existing column: columns={"time": NAME}'):
            pp.identify(named, columns={"angle [deg]": "Phi 1"})
        with self.assertRaisesRegex(pp.Error, 'columns "boom.angel" is not a channel'):
            pp.identify(named, columns={"boom.angel": "Phi 1"})

    def refused(self, change, **settings):
        frame = self.frame.copy()
        frame.index = [f"r{i}" for i in range(len(frame))]
        frame = change(frame)
        with self.assertRaises(pp.RecordError) as caught:
            pp.identify(frame, **settings)
        return caught.exception

    def test_a_wrong_reading_is_an_error_with_its_row_and_column(self):
        def broken(value, column, row=7):
            def change(frame):
                frame[column] = frame[column].astype(object)
                frame.iloc[row, frame.columns.get_loc(column)] = value
                return frame
            return change
        wrong = self.refused(broken("x", "boom.angle [deg]"))
        self.assertEqual((wrong.row, wrong.column), ("r7", "boom.angle [deg]"))
        self.assertIn('row r7, column "boom.angle [deg]": "x" is not a finite number', str(wrong))
        missing = self.refused(broken(float("nan"), "boom.spool [in]"))
        self.assertIn('row r7, column "boom.spool [in]": "nan" is not a reading', str(missing))
        self.assertIn('missing="skip" leaves out rows with missing readings', str(missing))
        late = self.refused(broken(0.01, "time [s]"))
        self.assertRegex(str(late), r'row r7, column "time \[s\]": the time is .* the time on row r6')
        unit = self.refused(lambda frame: frame.rename(columns={"boom.angle [deg]": "boom.angle [psi]"}))
        self.assertEqual((unit.row, unit.column), (None, "boom.angle [psi]"))
        self.assertIn('column "boom.angle [psi]": "psi" is not a unit of angle', str(unit))
        self.assertIn('the record: the column "time" is missing', str(self.refused(lambda f: f.drop(columns="time [s]"))))
        self.assertIn("0 samples", str(self.refused(lambda frame: frame.iloc[:0])))

    def test_rows_without_readings_are_left_out_with_a_warning(self):
        self.frame.loc[7, "boom.spool [in]"] = float("nan")
        with self.assertWarnsRegex(pp.RecordWarning, "row 7: a reading is missing\nhint: 1 row left out") as caught:
            found = pp.identify(self.frame, missing="skip")
        self.assertEqual(caught.filename, __file__)
        self.assertEqual(found.report["samples"], len(self.frame) - 1)

    def test_settings_that_do_not_fit_are_errors(self):
        for message, settings in (("links boom,arm: unknown link \"arm\"", {"links": ["boom", "arm"]}),
                                  ("samples works only with way thesis", {"samples": 5}),
                                  ("way = 'best', expected one of service, thesis, whole", {"way": "best"}),
                                  ("bits = 'many', expected a whole number", {"bits": "many"}),
                                  ("bits 53: expected 6 to 52", {"bits": 53}), ("window 0: expected 1 to", {"window": 0}),
                                  ("expected a whole number", {"population": -1}),
                                  ("no link has all readings|inlet_pressure", {"links": "stick"})):
            with self.subTest(message), self.assertRaisesRegex(pp.Error, message):
                pp.identify(self.frame, **settings)
        with self.assertRaisesRegex(TypeError, "no setting 'bit'"):
            pp.identify(self.frame, bit=3)
        with self.assertRaisesRegex(TypeError, "a pandas DataFrame, not str"):
            pp.identify(str(RECORD))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            pp.identify(self.frame)


if __name__ == "__main__":
    unittest.main()
