// Starts `placedpar language-server` for netlists, occam and studies.
"use strict";

const { workspace } = require("vscode");
const { LanguageClient, TransportKind } = require("vscode-languageclient/node");

let client;

exports.activate = () => {
  const command = workspace.getConfiguration("placedpar").get("path");
  client = new LanguageClient(
    "placedpar",
    "PlacedPar",
    { command, args: ["language-server"], transport: TransportKind.stdio },
    { documentSelector: [{ language: "placedpar-netlist" }, { language: "occam" }, { language: "toml", scheme: "file" }] }
  );
  return client.start();
};

exports.deactivate = () => client && client.stop();
