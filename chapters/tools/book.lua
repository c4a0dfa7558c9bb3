-- book.lua -- what pandoc does not do by itself: equations with their number
-- beside them, numbered captions below the figures, the place above each
-- listing, links from page to page.

local function equation_id(number) return "eq-" .. number:gsub("%.", "-") end

-- A display formula; with its number beside it and as its address if it has one.
local function display(math)
  local number = math.text:match("\\tag{([%w.]+)}")
  math.text = math.text:gsub("\\tag{[%w.]+}", "")
  local formula = pandoc.Span({ math }, pandoc.Attr("", { "formula" }))
  if not number then
    return pandoc.Div({ pandoc.Plain({ formula }) }, pandoc.Attr("", { "equation" }))
  end
  local link = pandoc.Link("(" .. number .. ")", "#" .. equation_id(number), "",
                           pandoc.Attr("", { "number" }))
  return pandoc.Div({ pandoc.Plain({ formula, link }) },
                    pandoc.Attr(equation_id(number), { "equation" }))
end

-- A paragraph that is an image becomes a figure; the paragraph after it that begins
-- with **Figure 9.1.** is its caption.
local function is_image(block)
  return block and block.t == "Para" and #block.content == 1
    and block.content[1].t == "Image"
end

local function is_caption(block)
  local first = block and block.t == "Para" and block.content[1]
  local mark = first and first.t == "Strong" and pandoc.utils.stringify(first)
  return mark and (mark == "Sketch." or mark:match("^Figure [%d.]+$"))
end

local function figure(image, caption)
  local large = pandoc.Link({ image }, image.src) -- alone in the window
  local out = pandoc.List({ pandoc.RawBlock("html", "<figure>"), pandoc.Plain({ large }) })
  if caption then
    out:extend({ pandoc.RawBlock("html", "<figcaption>"), pandoc.Plain(caption.content),
                 pandoc.RawBlock("html", "</figcaption>") })
  end
  out:insert(pandoc.RawBlock("html", "</figure>"))
  return out
end

local function figures(list)
  local out, i = pandoc.List(), 1
  while i <= #list do
    if is_image(list[i]) then
      local caption = is_caption(list[i + 1]) and list[i + 1]
      out:extend(figure(list[i].content[1], caption))
      i = i + (caption and 2 or 1)
    else
      out:insert(list[i])
      i = i + 1
    end
  end
  return out
end

-- A paragraph is cut where a display formula stands in it.
local function paragraph(block)
  local blocks, line = pandoc.List(), pandoc.List()
  local function flush()
    while #line > 0 and (line[#line].t == "Space" or line[#line].t == "SoftBreak") do
      line:remove()
    end
    while #line > 0 and line[1].t == "SoftBreak" do line:remove(1) end
    if #line > 0 then blocks:insert(pandoc.Para(line)) end
    line = pandoc.List()
  end
  for _, part in ipairs(block.content) do
    if part.t == "Math" and part.mathtype == "DisplayMath" then
      flush()
      blocks:insert(display(part))
    else
      line:insert(part)
    end
  end
  flush()
  return blocks
end

-- A command of a transcript on as many lines as it needs, cut between its words, so
-- that it can still be copied.
local function folded(command)
  local lines, line, quote = pandoc.List(), "", nil
  for space, word in command:gmatch("( *)([^ ]+)") do
    if not quote and line ~= "" and #line + #word > 84 then
      lines:insert(line .. " \\")
      line = "      " .. word
    else
      line = line .. space .. word
    end
    for mark in word:gmatch("['\"]") do
      if not quote then quote = mark elseif quote == mark then quote = nil end
    end
  end
  lines:insert(line)
  return table.concat(lines, "\n")
end

local function transcript(text)
  return (("\n" .. text):gsub("\n(%$ [^\n]+)", function(command)
    return "\n" .. (#command > 92 and folded(command) or command)
  end):sub(2))
end

-- Text with longer lines than a page of paper has room for is printed smaller.
local function is_wide(text)
  for line in text:gmatch("[^\n]+") do
    if #line > 100 then return true end
  end
  return false
end

-- The file and line above a listing.
local function blocks(list)
  local out = pandoc.List()
  for i, block in ipairs(list) do
    local what, file, line = nil, nil, nil
    if block.t == "RawBlock" then
      what, file = block.text:match("^<!%-%- (%a+) (%S+)")
    end
    local next_block = list[i + 1]
    if (what == "code" or what == "output" or what == "tests") and next_block
        and next_block.t == "CodeBlock" then
      file, line = file:match("^([^:]+):?(%d*)$")
      if what == "output" then next_block.text = transcript(next_block.text) end
      if is_wide(next_block.text) then next_block.classes:insert("wide") end
      local place = line ~= "" and "#L" .. line or ""
      local said = line ~= "" and file .. ", line " .. line or file
      out:insert(pandoc.Div({ pandoc.Plain({ pandoc.Link(said, file .. ".html" .. place) }) },
                            pandoc.Attr("", { "place" })))
    elseif block.t ~= "RawBlock" or not block.text:match("^<!%-%-") then
      out:insert(block)
    end
  end
  return out
end

local function link(item)
  local target = item.target
  if target:match("^%a+:") then return end
  if target:match("steps/README%.md$") then
    item.target = "steps.html"
  elseif target:match("^[%w-]+%.[ch]$") then -- beside steps/README.md
    item.target = "chapters/steps/" .. target .. ".html"
  elseif target:match("%.md") then
    item.target = target:gsub("^.*/", ""):gsub("README%.md", "index.md")
      :gsub("%.md", ".html")
  elseif target:match("%.patch$") then
    item.target = "chapters/solutions/" .. target:gsub("^.*/", "") .. ".html"
  elseif target:match("^%.%./") then
    while target:match("^%.%./") do target = target:sub(4) end
    item.target = target:gsub("^([^#]+)", "%1.html")
  end
  return item
end

local function image(item)
  item.src = item.src:gsub("^[%./]+/", "")
  return item
end

local function raw(item)
  if item.text:match("^<br") then return pandoc.LineBreak() end
  if item.text:match("^<!%-%-") then return {} end
end

-- A long name may be broken after an underscore.
local function code(item)
  if #item.text < 24 or not item.text:find("_") then return end
  local text = item.text:gsub("&", "&amp;"):gsub("<", "&lt;"):gsub("_", "_<wbr />")
  return pandoc.RawInline("html", "<code>" .. text .. "</code>")
end

return {
  { Link = link, Image = image, RawInline = raw, Code = code },
  { Blocks = blocks },
  { Blocks = figures },
  { Para = paragraph },
}
