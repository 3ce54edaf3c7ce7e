-- Frob for Neovim 0.7 and later: starts the language server `frobc lsp` for each program, and
-- defines the commands of its code lenses.
local frob = {}

-- Options: cmd, the command that starts the server; inlay_hints; and any option of
-- vim.lsp.start_client, such as on_attach and capabilities.
frob.options = { cmd = { 'frobc', 'lsp' }, inlay_hints = false }

-- The folder of the project: the closest parent that contains .git, or else the folder of the file.
local function root_of(path)
  local folder = vim.fn.fnamemodify(path, ':p:h')
  local found = vim.fn.finddir('.git', folder .. ';')
  return found ~= '' and vim.fn.fnamemodify(found, ':p:h:h') or folder
end

local clients = {} -- by root

function frob.start(buffer)
  local path = vim.api.nvim_buf_get_name(buffer)
  local root = root_of(path ~= '' and path or vim.fn.getcwd() .. '/unnamed')
  local options = vim.tbl_extend('force', { name = 'frobc' }, frob.options)
  options.root_dir = root
  options.inlay_hints = nil
  options.init_options = { inlayHints = frob.options.inlay_hints }
  if not clients[root] or not vim.lsp.get_client_by_id(clients[root]) then
    clients[root] = vim.lsp.start_client(options)
  end
  if clients[root] then
    vim.lsp.buf_attach_client(buffer, clients[root])
  end
end

local function in_terminal(...)
  vim.cmd('botright new')
  vim.fn.termopen({ frob.options.cmd[1], ... })
end

function frob.setup(options)
  frob.options = vim.tbl_extend('force', frob.options, options or {})
  vim.lsp.commands['frob.run'] = function(command)
    in_terminal('run', command.arguments[1], '--view')
  end
  vim.lsp.commands['frob.report'] = function(command)
    in_terminal('report', command.arguments[1])
  end
  vim.lsp.commands['frob.test'] = function(command)
    in_terminal('test', command.arguments[1], '-k', command.arguments[2])
  end
  vim.api.nvim_create_autocmd('FileType', {
    pattern = 'frob',
    callback = function(event) frob.start(event.buf) end,
  })
end

return frob
