// Frob for Visual Studio Code: starts `frobc lsp`, and runs the commands of its code lenses.
const vscode = require("vscode");
const { LanguageClient } = require("vscode-languageclient/node");

let client;

const setting = (name) => vscode.workspace.getConfiguration("frob").get(name);

function inTerminal(command, path, ...options) {
    const file = path || vscode.window.activeTextEditor?.document.uri.fsPath;
    if (!file) return;
    const terminal = vscode.window.createTerminal({
        name: `frobc ${command}`,
        shellPath: setting("compiler"),
        shellArgs: [command, file, ...options],
    });
    terminal.show(true);
}

async function start() {
    const server = { command: setting("compiler"), args: ["lsp"] };
    client = new LanguageClient("frob", "Frob", server, {
        documentSelector: [{ language: "frob" }],
        initializationOptions: { inlayHints: setting("inlayHints") },
        synchronize: {
            configurationSection: "frob",
            fileEvents: vscode.workspace.createFileSystemWatcher("**/*.frob"),
        },
    });
    try {
        await client.start();
    } catch (error) {
        vscode.window.showErrorMessage(
            `Frob: ${setting("compiler")} lsp does not start (${error.message}). ` +
                "Install frobc, or set frob.compiler to its path.",
        );
    }
}

exports.activate = async (context) => {
    context.subscriptions.push(
        vscode.commands.registerCommand("frob.run", (path) => inTerminal("run", path, "--view")),
        vscode.commands.registerCommand("frob.report", (path) => inTerminal("report", path)),
        vscode.commands.registerCommand("frob.test", (path, label) =>
            inTerminal("test", path, ...(label ? ["-k", label] : [])),
        ),
        vscode.workspace.onDidChangeConfiguration(async (event) => {
            if (!event.affectsConfiguration("frob.compiler")) return;
            await client?.stop();
            await start();
        }),
    );
    await start();
};

exports.deactivate = () => client?.stop();
