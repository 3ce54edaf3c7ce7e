-- Shows what a user of Neovim sees of the language server.
local file = 'drive.frob'
require('frob').setup()
vim.cmd('filetype plugin on | syntax on')
vim.cmd('edit ' .. file)

local function say(...) io.write(table.concat({ ... }, ' ') .. '\n') end
local function wait(condition) assert(vim.wait(30000, condition, 20), 'nothing came') end

wait(function() return #vim.lsp.buf_get_clients() > 0 end)
wait(function() return #vim.diagnostic.get(0) > 0 end)
for _, d in ipairs(vim.diagnostic.get(0)) do
  say('message', d.lnum .. ':' .. d.col, d.code, (d.message:gsub('\n.*', '')))
end
say('syntax', vim.fn.synIDattr(vim.fn.synID(3, 1, 1), 'name'),
  vim.fn.synIDattr(vim.fn.synID(1, 1, 1), 'name'))

local function ask(method, line, character, more)
  local params = { textDocument = vim.lsp.util.make_text_document_params(),
    position = { line = line, character = character } }
  local answers = vim.lsp.buf_request_sync(0, 'textDocument/' .. method,
    vim.tbl_extend('force', params, more or {}), 30000)
  for _, answer in pairs(answers) do return answer.result end
end

say('hover', (ask('hover', 2, 0).contents.value:gsub('\n', ' ')))
say('definition', ask('definition', 5, 4).range.start.line)

-- Apply the fix that the message offers.
local d = vim.diagnostic.get(0)[1]
local at = { line = d.lnum, character = d.col }
local actions = ask('codeAction', d.lnum, d.col, {
  range = { start = at, ['end'] = at }, context = { diagnostics = {} } })
say('action', actions[1].title)
vim.lsp.util.apply_workspace_edit(actions[1].edit, 'utf-16')
wait(function() return #vim.diagnostic.get(0) == 0 end)
say('mended')

vim.lsp.util.apply_workspace_edit(ask('rename', 2, 0, { newName = 'fastest' }), 'utf-16')
vim.lsp.util.apply_text_edits(
  ask('formatting', 0, 0, { options = { tabSize = 4, insertSpaces = true } }),
  vim.api.nvim_get_current_buf(), 'utf-16')
say(table.concat(vim.api.nvim_buf_get_lines(0, 0, -1, false), '\n'))
vim.cmd('qall!')
