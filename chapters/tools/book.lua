-- book.lua -- what pandoc does not do by itself: numbers of equations, links to
-- equations and sources, the place above each listing, links between pages.
--
-- `anchors` is a file with one "(9.1) 09-drag.html" or "Saad03 references.html"
-- a line: everything that may be linked to by its name.

local page_of = {}
local document = { SX15 = true, XS11 = true, LS = true, EW18 = true }

local function read_anchors(meta)
  for line in io.lines(pandoc.utils.stringify(meta.anchors)) do
    local name, page = line:match("^(%S+) (%S+)$")
    page_of[name] = page
  end
end

local function equation_id(number) return "eq-" .. number:gsub("%.", "-") end

-- A display formula; with its number beside it and as its address if it has one.
local function display(math)
  local number = math.text:match("\\tag{([%w.]+)}")
  math.text = math.text:gsub("\\tag{[%w.]+}", "")
  if not number then return pandoc.Div({ pandoc.Plain({ math }) },
                                       pandoc.Attr("", { "equation" })) end
  local link = pandoc.Link("(" .. number .. ")", "#" .. equation_id(number), "",
                           pandoc.Attr("", { "number" }))
  return pandoc.Div({ pandoc.Plain({ math, link }) },
                    pandoc.Attr(equation_id(number), { "equation" }))
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

-- "[XS11 2.13]", "[XS11 (2.11), (2.12)]", "[Saad03, 9.5]": where it leads.
local function cited(text)
  local key, place = text:match("^%[([A-Z]%w+)[%s,]*(.-)%]")
  if document[key] then
    place = place:gsub("[()]", "")
    local number = place:match("^[AB]%.%d+%a?") or place:match("^%d[%d.]*%a?")
    if place:match("^Algorithm") then number = "Algorithm 3.1" end
    local id = number and (key .. " " .. number):lower():gsub("[ .]", "-")
    return id and page_of[id] and page_of[id] .. "#" .. id
      or "references.html#" .. key
  end
  return key and page_of[key] and "references.html#" .. key
end

-- Links citations and, outside of them, numbers of equations.
local function inlines(list)
  local out, i = pandoc.List(), 1
  while i <= #list do
    local item = list[i]
    local done = false
    if item.t == "Str" and item.text:match("^%(?%[[A-Z]%w+") then
      local last = i
      while last < #list and not (list[last].t == "Str" and list[last].text:find("%]")) do
        last = last + 1
      end
      local words = {}
      for k = i, last do words[#words + 1] = pandoc.utils.stringify(list[k]) end
      local text = table.concat(words, ""):gsub("\n", " ")
      local before, core, after = text:match("^(%(?)(%[.-%])(.*)$")
      local target = core and cited(core)
      if target then
        out:extend({ pandoc.Str(before), pandoc.Link(core, target), pandoc.Str(after) })
        i = last + 1
        done = true
      end
    end
    if not done then
      local before, number, after
      if item.t == "Str" then
        before, number, after = item.text:match("^(.-)(%(%d+%.%d+%a?%))([^%]]*)$")
      end
      if number and page_of[number] then
        local id = equation_id(number:sub(2, -2))
        out:extend({ pandoc.Str(before),
                     pandoc.Link(number, page_of[number] .. "#" .. id),
                     pandoc.Str(after) })
      else
        out:insert(item)
      end
      i = i + 1
    end
  end
  return out
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
  if target:match("%.md") then
    item.target = target:gsub("README%.md", "index.md"):gsub("%.md", ".html")
  elseif target:match("^%.%./") then
    item.target = target:gsub("^%.%./([^#]+)", "%1.html")
  end
  return item
end

local function image(item)
  item.src = item.src:gsub("^%.%./", "")
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
  { Meta = read_anchors },
  { Link = link, Image = image, RawInline = raw, Code = code },
  { Blocks = blocks },
  { Inlines = inlines },
  { Para = paragraph },
}
